/* A PLC program: the ram moves down when it is up. */
#include <symplant/program.h>

static const struct symplant_variable variables[] = {
    {.symbol = "HALL2_PRESS_RAM_I_UP", .bits = 1},
    {.symbol = "HALL2_PRESS_RAM_O_DOWN", .writes = 1, .bits = 1},
};

static void *create(void *const *cells) { return (void *)cells; }

static int scan(void *instance, int64_t now_ns) {
  uint8_t *const *cells = instance;
  (void)now_ns;
  if (*cells[0]) *cells[1] = 1;
  return 0;
}

static void destroy(void *instance) { (void)instance; }

const struct symplant_program *symplant_program_v1(void) {
  static const struct symplant_program program = {1, sizeof program, "ram", 0, variables, 2, create, scan, destroy};
  return &program;
}
