fn land() {}
