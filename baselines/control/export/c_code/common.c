#include "heli_controller.h"

#include <math.h>

/* Signals, signs and units: README.md. Arrays are in flash: nothing is allocated. */

#define LAST (SAMPLES - 1)

/* The nearest voltage that the amplifier can give; what is no number is the voltage nearest to zero. */
static real saturate(real u) {
    if (!(u >= U_MIN)) {
        return u < U_MIN ? U_MIN : SAFE_VOLTAGE;
    }
    return u <= U_MAX ? u : U_MAX;
}
