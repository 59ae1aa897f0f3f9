/* Loads the library of an FMU, as an importer on Windows does: usage fmu_step.exe DLL RESOURCES GUID INPUT OUTPUT. Sets
 * the BOOL input, makes steps of 0.1 s, and prints when the BOOL output changes. INPUT and OUTPUT are value references. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <windows.h>

typedef void (*Logger)(void*, const char*, int, const char*, const char*, ...);
typedef struct {
  Logger logger;
  void* unused[3];
  void* environment;
} Callbacks;

static void log_message(void* environment, const char* instance, int status, const char* category, const char* message, ...) {
  (void)environment, (void)instance;
  printf("status %d %s: %s\n", status, category, message);
}

static FARPROC find(HMODULE library, const char* name) {
  FARPROC const found = GetProcAddress(library, name);
  if (found == NULL) printf("no function %s\n", name), exit(1);
  return found;
}

int main(int count, char** arguments) {
  if (count != 6) return 2;
  HMODULE const library = LoadLibraryA(arguments[1]);
  if (library == NULL) return printf("cannot load %s: error %lu\n", arguments[1], GetLastError()), 1;
  void* (*instantiate)(const char*, int, const char*, const char*, const Callbacks*, int, int);
  int (*experiment)(void*, int, double, double, int, double);
  int (*enter)(void*), (*leave)(void*);
  int (*set)(void*, const unsigned*, size_t, const int*), (*get)(void*, const unsigned*, size_t, int*);
  int (*step)(void*, double, double, int);
  void (*release)(void*);
  *(FARPROC*)&instantiate = find(library, "fmi2Instantiate");
  *(FARPROC*)&experiment = find(library, "fmi2SetupExperiment");
  *(FARPROC*)&enter = find(library, "fmi2EnterInitializationMode");
  *(FARPROC*)&leave = find(library, "fmi2ExitInitializationMode");
  *(FARPROC*)&set = find(library, "fmi2SetBoolean");
  *(FARPROC*)&get = find(library, "fmi2GetBoolean");
  *(FARPROC*)&step = find(library, "fmi2DoStep");
  *(FARPROC*)&release = find(library, "fmi2FreeInstance");

  const Callbacks callbacks = {log_message, {NULL, NULL, NULL}, NULL};
  void* const plant = instantiate("plant", 1, arguments[3], arguments[2], &callbacks, 0, 0);
  if (plant == NULL || experiment(plant, 0, 0, 0, 0, 0) != 0 || enter(plant) != 0 || leave(plant) != 0) return 1;
  const unsigned input = (unsigned)strtoul(arguments[4], NULL, 10);
  const unsigned output = (unsigned)strtoul(arguments[5], NULL, 10);
  const int on = 1;
  int before = 0, now = 0;
  if (set(plant, &input, 1, &on) != 0 || get(plant, &output, 1, &before) != 0) return 1;
  for (int i = 0; i < 50; ++i) {
    if (step(plant, i * 0.1, 0.1, 1) != 0 || get(plant, &output, 1, &now) != 0) return 1;
    if (now != before) printf("%.1f s: %d\n", (i + 1) * 0.1, now);
    before = now;
  }
  release(plant);
  return 0;
}
