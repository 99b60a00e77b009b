#include "cli/program.h"

int main(int argc, char** argv) {
  return thiessen::cli::run_program(argc, argv);
}
