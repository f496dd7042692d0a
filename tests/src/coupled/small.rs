//! Linear algebra on a handful of unknowns.

/// A matrix of at most five rows and columns, the rest unused.
pub(super) type Small = [[f64; 5]; 5];

/// Solves A X = B for `n` unknowns and right-hand sides by elimination with complete pivoting.
#[allow(clippy::needless_range_loop, reason = "indices of an elimination")]
pub(super) fn solve(n: usize, mut a: Small, mut b: Small) -> Small {
    let mut order = [0, 1, 2, 3, 4];
    for k in 0..n {
        let (row, column) = largest(&a, k..n, k..n);
        a.swap(k, row);
        b.swap(k, row);
        order.swap(k, column);
        for row in &mut a {
            row.swap(k, column);
        }
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            for j in 0..n {
                b[i][j] -= factor * b[k][j];
            }
        }
    }
    let mut x = [[0.0; 5]; 5];
    for j in 0..n {
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| a[i][k] * x[order[k]][j]).sum();
            x[order[i]][j] = (b[i][j] - known) / a[i][i];
        }
    }
    x
}

/// Where the largest entry of these rows and columns stands.
fn largest(a: &Small, rows: core::ops::Range<usize>, columns: core::ops::Range<usize>) -> (usize, usize) {
    let places = rows.flat_map(|i| columns.clone().map(move |j| (i, j)));
    places.max_by(|&(i, j), &(k, l)| a[i][j].abs().total_cmp(&a[k][l].abs())).unwrap()
}

/// Negative eigenvalues of a symmetric matrix, by Bunch and Parlett's pivoting; nothing where it holds
/// a number that is none.
#[allow(clippy::needless_range_loop, reason = "indices of an elimination")]
pub(super) fn negative(n: usize, mut a: Small) -> Option<usize> {
    // Bunch and Parlett's (1 + √17)/8, which bounds the growth of the entries.
    const DIAGONAL: f64 = 0.64;
    let (mut k, mut count) = (0, 0);
    while k < n {
        let (p, q) = largest(&a, k..n, k..n);
        let top = (k..n).max_by(|&i, &j| a[i][i].abs().total_cmp(&a[j][j].abs()))?;
        if !a[p][q].is_finite() {
            return None;
        }
        if a[p][q] == 0.0 {
            return Some(count);
        }
        if a[top][top].abs() >= DIAGONAL * a[p][q].abs() {
            exchange(&mut a, k, top);
            let pivot = a[k][k];
            count += usize::from(pivot < 0.0);
            for i in k + 1..n {
                let factor = a[i][k] / pivot;
                for j in k + 1..n {
                    a[i][j] -= factor * a[k][j];
                }
            }
            k += 1;
        } else {
            // One positive and one negative eigenvalue.
            let (p, q) = (p.min(q), p.max(q));
            exchange(&mut a, k, p);
            exchange(&mut a, k + 1, q);
            count += 1;
            let determinant = a[k][k] * a[k + 1][k + 1] - a[k + 1][k] * a[k + 1][k];
            for i in k + 2..n {
                let first = (a[i][k] * a[k + 1][k + 1] - a[i][k + 1] * a[k + 1][k]) / determinant;
                let second = (a[i][k + 1] * a[k][k] - a[i][k] * a[k + 1][k]) / determinant;
                for j in k + 2..n {
                    a[i][j] -= first * a[k][j] + second * a[k + 1][j];
                }
            }
            k += 2;
        }
    }
    Some(count)
}

/// Exchanges two unknowns of a symmetric matrix.
fn exchange(a: &mut Small, i: usize, j: usize) {
    a.swap(i, j);
    for row in a {
        row.swap(i, j);
    }
}

/// Combinations of `n` unknowns on which `m` conditions vanish, n − m of them, as columns; and how far
/// the conditions are from depending on one another, which is |det| where m = n. Nothing where they do.
#[allow(clippy::needless_range_loop, reason = "indices of an elimination")]
pub(super) fn kernel(n: usize, m: usize, mut a: Small) -> Option<(Vec<[f64; 5]>, f64)> {
    let mut order = [0, 1, 2, 3, 4];
    let mut size = 1.0;
    for k in 0..m {
        let (row, column) = largest(&a, k..m, k..n);
        a.swap(k, row);
        order.swap(k, column);
        for row in &mut a {
            row.swap(k, column);
        }
        let pivot = a[k][k];
        size *= pivot.abs();
        if m == n && k + 1 == n {
            break;
        }
        if pivot == 0.0 {
            return None;
        }
        for j in k..n {
            a[k][j] /= pivot;
        }
        for i in (0..m).filter(|&i| i != k) {
            let factor = a[i][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
        }
    }
    let columns = (m..n).map(|free| {
        let mut column = [0.0; 5];
        column[order[free]] = 1.0;
        for k in 0..m {
            column[order[k]] = -a[k][free];
        }
        column
    });
    Some((columns.collect(), size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvalues_are_counted_by_their_signs() {
        let matrix = |f: fn(usize, usize) -> f64| core::array::from_fn(|i| core::array::from_fn(|j| f(i, j)));
        assert_eq!(negative(5, matrix(|i, j| if i == j { 1.0 } else { 0.0 })), Some(0));
        assert_eq!(negative(4, matrix(|i, j| if i + j == 3 { 1.0 } else { 0.0 })), Some(2));
        // I − J/3 has the eigenvalues 1 and 1 − n/3.
        assert_eq!(negative(5, matrix(|i, j| f64::from(u8::from(i == j)) - 1.0 / 3.0)), Some(1));
        assert_eq!(negative(2, matrix(|i, j| if i == j { f64::NAN } else { 0.0 })), None);
    }

    #[test]
    fn solutions_meet_their_equations() {
        let a: Small = core::array::from_fn(|i| core::array::from_fn(|j| 1.0 / (1 + i + j * j) as f64));
        let x: Small = core::array::from_fn(|i| core::array::from_fn(|j| (i * i + j) as f64));
        let product = |p: &Small, q: &Small, n: usize| -> Small {
            core::array::from_fn(|i| core::array::from_fn(|j| (0..n).map(|k| p[i][k] * q[k][j]).sum()))
        };
        let found = product(&a, &solve(4, a, product(&a, &x, 4)), 4);
        let expected = product(&a, &x, 4);
        let near = |i: usize, j: usize| (found[i][j] - expected[i][j]).abs() < 1e-12 * expected[i][j].abs().max(1.0);
        assert!((0..4).all(|i| (0..4).all(|j| near(i, j))), "{found:?}");
        for column in kernel(5, 2, a).unwrap().0 {
            for row in &a[..2] {
                let left: f64 = row.iter().zip(column).map(|(a, x)| a * x).sum();
                assert!(left.abs() < 1e-13, "{left}");
            }
        }
    }
}
