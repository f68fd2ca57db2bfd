#include "harness/main.h"

int main(int argc, char** argv) { return mb::harness_main(argc, argv, mb::default_catalogue()); }
