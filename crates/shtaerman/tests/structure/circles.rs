//! Circles in a graph: its strongly connected components of more than one node.

use std::collections::{BTreeMap, BTreeSet};

/// Which nodes each node points to.
pub(crate) type Graph = BTreeMap<String, BTreeSet<String>>;

/// Sets of nodes from each of which all others of the set are reached.
pub(crate) fn circles(graph: &Graph) -> BTreeSet<BTreeSet<String>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> =
        graph.keys().map(|node| (node.as_str(), reached(graph, node))).collect();
    let reaches = |from: &str, to: &str| reached.get(from).is_some_and(|all| all.contains(to));
    let around = |node: &str| {
        let others = graph.keys().filter(|other| reaches(node, other) && reaches(other, node));
        others.cloned().collect::<BTreeSet<String>>()
    };
    graph.keys().map(|node| around(node)).filter(|circle| circle.len() > 1).collect()
}

/// Everything that a node points to, straight or through others.
fn reached<'g>(graph: &'g Graph, start: &str) -> BTreeSet<&'g str> {
    let mut seen = BTreeSet::new();
    let mut open = vec![start];
    while let Some(node) = open.pop() {
        for next in graph.get(node).into_iter().flatten() {
            if seen.insert(next.as_str()) {
                open.push(next);
            }
        }
    }
    seen
}

#[test]
fn circles_are_found_and_chains_are_not() {
    let graph = |arrows: &[(&str, &str)]| {
        let mut graph = Graph::new();
        for (from, to) in arrows {
            graph.entry((*to).to_owned()).or_default();
            graph.entry((*from).to_owned()).or_default().insert((*to).to_owned());
        }
        graph
    };
    let set = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<BTreeSet<_>>();
    assert!(circles(&graph(&[("a", "b"), ("b", "c"), ("a", "c")])).is_empty());
    let found = circles(&graph(&[("a", "b"), ("b", "c"), ("c", "a"), ("c", "d"), ("e", "a")]));
    assert_eq!(found, BTreeSet::from([set(&["a", "b", "c"])]));
    let found = circles(&graph(&[("a", "b"), ("b", "a"), ("b", "c"), ("c", "d"), ("d", "c")]));
    assert_eq!(found, BTreeSet::from([set(&["a", "b"]), set(&["c", "d"])]));
}
