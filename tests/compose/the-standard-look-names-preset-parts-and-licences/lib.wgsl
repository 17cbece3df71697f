// SPDX-License-Identifier: Apache-2.0

fn f() -> f32 { return 1.0; }
