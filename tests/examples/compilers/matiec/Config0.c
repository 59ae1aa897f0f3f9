/* A configuration with two tasks, of 20 and 50 ms, in the form in which matiec's iec2c writes one. */
void RES0_init__(void);
void RES0_run__(unsigned long tick);

void config_init__(void) { RES0_init__(); }
void config_run__(unsigned long tick) { RES0_run__(tick); }
unsigned long long common_ticktime__ = 10000000ULL; /*ns*/
