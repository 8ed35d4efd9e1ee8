#include "heli_controller.h"

#include <math.h>

/* Signals, signs and units: README.md. Arrays are in flash: nothing is allocated. */

#define LAST (SAMPLES - 1)

/* Index of the sample nearest to the time t; what is no number counts as the start. */
static inline int index_of(real t) {
    const real s = t / PERIOD + REAL(0.5);
    if (!(s > REAL(0.0))) {
        return 0;
    }
    return s < (real)LAST ? (int)s : LAST;
}

/* Whether all of y that is read are numbers. */
static int is_measured(const real y[6]) {
    for (int i = 0; i < 6; i += ANGLES_ONLY ? 2 : 1) {
        if (!isfinite(y[i])) {
            return 0;
        }
    }
    return 1;
}

/* The nearest voltage that the amplifier can give; what is no number is the voltage nearest to zero. */
static real saturate(real u) {
    if (!(u >= U_MIN)) {
        return u < U_MIN ? U_MIN : SAFE_VOLTAGE;
    }
    return u <= U_MAX ? u : U_MAX;
}
