// What the regulators and the filter need of matrices, which are arrays of rows.

export type Matrix = number[][];

export const transposed = (A: Matrix): Matrix => A[0].map((_, j) => A.map((row) => row[j]));
/** A z. */
export function applied(A: Matrix, z: readonly number[]): number[] {
  return A.map((row) => {
    let sum = 0;
    for (let k = 0; k < row.length; k++) sum += row[k] * z[k];
    return sum;
  });
}
/** A B. */
export function times(A: Matrix, B: Matrix): Matrix {
  const columns = transposed(B);
  return A.map((row) => applied(columns, row));
}
/** a - b, of vectors. */
export const minus = (a: readonly number[], b: readonly number[]): number[] => a.map((value, i) => value - b[i]);
/** A + h B. */
export const plus = (A: Matrix, B: Matrix, h = 1): Matrix => A.map((row, i) => row.map((a, j) => a + h * B[i][j]));
export const scaled = (A: Matrix, h: number): Matrix => A.map((row) => row.map((a) => h * a));
/** The mean of A and its transpose. */
export const symmetric = (A: Matrix): Matrix => A.map((row, i) => row.map((a, j) => 0.5 * (a + A[j][i])));
export const zeros = (rows: number, columns: number): Matrix =>
  Array.from({ length: rows }, () => new Array<number>(columns).fill(0));
export const diagonal = (values: readonly number[]): Matrix =>
  values.map((value, i) => values.map((_, j) => (i === j ? value : 0)));

/** A^-1 B for a symmetric, positive definite A, by elimination without pivots. */
export function solved(A: Matrix, B: Matrix): Matrix {
  const n = A.length;
  const rows = A.map((row, i) => [...row, ...B[i]]);
  for (let k = 0; k < n; k++) {
    rows[k] = rows[k].map((value) => value / rows[k][k]);
    for (let i = 0; i < n; i++) {
      if (i === k) continue;
      const factor = rows[i][k];
      rows[i] = rows[i].map((value, j) => value - factor * rows[k][j]);
    }
  }
  return rows.map((row) => row.slice(n));
}

/** The numbers of a base64 of float32. */
export const float32 = (base64: string): number[] =>
  Array.from(new Float32Array(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer));
