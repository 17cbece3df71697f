/* Höhe in Metern: 高さ 🏔 */ const 高さ: f32 = /* über */ nirgendwo + 1.0;
