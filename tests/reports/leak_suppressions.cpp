// fontconfig keeps its configuration until the process ends; the leak sanitizer need not report that.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
