static real @rotor@_thrust(real u) {
    int k = 0;
    real s;
    if (u < @ROTOR@_VOLTAGES[0]) {
        return @ROTOR@_THRUSTS[0] + @ROTOR@_BELOW * (u - @ROTOR@_VOLTAGES[0]);
    }
    if (u > @ROTOR@_VOLTAGES[@ROTOR@_POINTS - 1]) {
        return @ROTOR@_THRUSTS[@ROTOR@_POINTS - 1] + @ROTOR@_ABOVE * (u - @ROTOR@_VOLTAGES[@ROTOR@_POINTS - 1]);
    }
    while (k < @ROTOR@_POINTS - 2 && u >= @ROTOR@_VOLTAGES[k + 1]) {
        k++;
    }
    s = u - @ROTOR@_VOLTAGES[k];
    return ((@ROTOR@_CUBIC[k][0] * s + @ROTOR@_CUBIC[k][1]) * s + @ROTOR@_CUBIC[k][2]) * s + @ROTOR@_CUBIC[k][3];
}

static real @rotor@_voltage(real f) {
    int k = 0;
    real low = REAL(0.0), high, s, target;
    if (f == @rotor@_thrust(REAL(0.0))) {
        return REAL(0.0);
    }
    if (f < @ROTOR@_THRUSTS[0]) {
        return @ROTOR@_VOLTAGES[0] + (f - @ROTOR@_THRUSTS[0]) / @ROTOR@_BELOW;
    }
    if (f > @ROTOR@_THRUSTS[@ROTOR@_POINTS - 1]) {
        return @ROTOR@_VOLTAGES[@ROTOR@_POINTS - 1] + (f - @ROTOR@_THRUSTS[@ROTOR@_POINTS - 1]) / @ROTOR@_ABOVE;
    }
    while (k < @ROTOR@_POINTS - 2 && f > @ROTOR@_THRUSTS[k + 1]) {
        k++;
    }
    high = @ROTOR@_VOLTAGES[k + 1] - @ROTOR@_VOLTAGES[k];
    s = REAL(0.5) * high;
    target = f - @ROTOR@_CUBIC[k][3];
    for (int iteration = 0; iteration < 80; iteration++) {
        const real *c = @ROTOR@_CUBIC[k];
        const real miss = ((c[0] * s + c[1]) * s + c[2]) * s - target;
        const real slope = (REAL(3.0) * c[0] * s + REAL(2.0) * c[1]) * s + c[2];
        real next = slope > REAL(0.0) ? s - miss / slope : low - REAL(1.0);
        if (miss <= REAL(0.0)) {
            low = s;
        }
        if (miss >= REAL(0.0)) {
            high = s;
        }
        if (!(next >= low && next <= high)) {
            next = REAL(0.5) * (low + high);
        }
        if (FABS(next - s) <= ROUNDING) {
            break;
        }
        s = next;
    }
    return @ROTOR@_VOLTAGES[k] + s;
}
