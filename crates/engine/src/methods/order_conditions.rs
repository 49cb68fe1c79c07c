//! Order conditions of one-step methods by rooted trees (Hairer, Norsett & Wanner I, section II.2, theorem 2.13; Rosenbrock
//! methods: Hairer & Wanner II, section IV.7, theorem 7.3), for tests of coefficients.

use super::equations::Equations;

/// A rooted tree: its subtrees, in no particular order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Tree(Vec<Tree>);

impl Tree {
    /// All trees of `order` vertices.
    pub fn of_order(order: usize) -> Vec<Self> {
        let mut trees: Vec<Self> = forests(order - 1).into_iter().map(Tree).collect();
        trees.sort();
        trees.dedup();
        trees
    }

    fn order(&self) -> usize {
        1 + self.0.iter().map(Self::order).sum::<usize>()
    }

    fn density(&self) -> f64 {
        self.order() as f64 * self.0.iter().map(Self::density).product::<f64>()
    }

    /// Product over the subtrees at stage `stage`.
    fn product(&self, method: &Method, stage: usize) -> f64 {
        // Rosenbrock methods: a vertex with a single branch stands for the Jacobian, which uses the matrix alpha + gamma.
        let matrix = if self.0.len() == 1 { &method.single } else { &method.several };
        let sum = |subtree: &Self| -> f64 {
            (0..method.weights.len()).map(|j| matrix[stage][j] * subtree.product(method, j)).sum()
        };
        self.0.iter().map(sum).product()
    }
}

/// All sorted lists of trees with `vertices` vertices together.
fn forests(vertices: usize) -> Vec<Vec<Tree>> {
    if vertices == 0 {
        return vec![Vec::new()];
    }
    let mut found = Vec::new();
    for first in 1..=vertices {
        for tree in Tree::of_order(first) {
            for mut rest in forests(vertices - first) {
                rest.push(tree.clone());
                rest.sort();
                found.push(rest);
            }
        }
    }
    found
}

/// A method as full square matrices.
pub(crate) struct Method {
    /// For vertices with one branch: alpha + gamma; for an explicit method equal to `several`.
    pub single: Vec<Vec<f64>>,
    /// For vertices with several branches: alpha.
    pub several: Vec<Vec<f64>>,
    /// b, or the weights of a continuous extension.
    pub weights: Vec<f64>,
}

impl Method {
    /// Greatest violation of the conditions of `order` for the solution at `part` of the step, 0 to 1.
    pub fn residual(&self, order: usize, part: f64) -> f64 {
        let power = (0..order).fold(1.0, |power, _| power * part);
        let mut greatest = 0.0_f64;
        for tree in Tree::of_order(order) {
            let weight: f64 =
                (0..self.weights.len()).map(|stage| self.weights[stage] * tree.product(self, stage)).sum();
            greatest = greatest.max((weight - power / tree.density()).abs());
        }
        greatest
    }
}

/// Measured order of a method with constant step on a nonlinear, driven pendulum. `step` makes one step; its arguments are
/// equations, time, size, from, to.
pub(crate) fn measured(mut step: impl FnMut(&mut Equations, f64, f64, &[f64], &mut [f64])) -> f64 {
    let text = "independent t\nq'' = -sin(q) - 0.2*q' + cos(2*t)\nq(0) = 1\nq'(0) = 0.5\n";
    let (model, diagnostics) = model::compile(text, std::slice::from_ref(&(0..text.len())));
    let model = model.map(|checked| checked.model);
    let model = model.unwrap_or_else(|| panic!("{diagnostics:?}"));
    let mut equations = Equations::with_slopes(&model).unwrap();
    equations.prepare(&[], &[], &[1.0, 0.5]);
    let mut end = |steps: u32| {
        let size = 4.0 / f64::from(steps);
        let (mut from, mut to) = ([1.0, 0.5], [0.0; 2]);
        for index in 0..steps {
            step(&mut equations, f64::from(index) * size, size, &from, &mut to);
            from = to;
        }
        from[0]
    };
    // Three runs give the order without the exact solution (Richardson).
    let (coarse, middle, fine) = (end(100), end(200), end(400));
    libm::log2(((coarse - middle) / (middle - fine)).abs())
}

#[test]
fn there_are_as_many_trees_as_cayley_counted() {
    let counts: Vec<usize> = (1..=6).map(|order| Tree::of_order(order).len()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20]);
}
