/* The types of a program in the form in which matiec's iec2c writes one. No line is that compiler's. */
#ifndef IEC_TYPES_ALL_H
#define IEC_TYPES_ALL_H

#include <stdint.h>

typedef uint8_t BOOL;
typedef int16_t INT;
typedef struct {
  long int tv_sec;
  long int tv_nsec;
} TIME;

#endif
