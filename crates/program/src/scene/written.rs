//! Serialized form of a scene: a list of elements, so that reading needs no recursion.

use super::{Child, Element, Scene, Written, WrittenChild, WrittenElement};

/// Maximum nesting of elements; documents allow less.
const DEEPEST: usize = 64;

impl From<Scene> for Written {
    fn from(scene: Scene) -> Self {
        let mut written =
            Self { elements: Vec::new(), values: scene.values, trails: scene.trails, length: scene.length };
        written.add(scene.root);
        written
    }
}

impl Written {
    /// Appends an element after its children and returns its index.
    fn add(&mut self, element: Element) -> u32 {
        let Element { name, attributes, children, drag } = element;
        let children = children.into_iter().map(|child| match child {
            Child::Element(inner) => WrittenChild::Element(self.add(inner)),
            Child::Text(text) => WrittenChild::Text(text),
        });
        let children = children.collect();
        self.elements.push(WrittenElement { name, attributes, children, drag });
        (self.elements.len() - 1) as u32
    }
}

impl TryFrom<Written> for Scene {
    type Error = &'static str;

    fn try_from(written: Written) -> Result<Self, Self::Error> {
        // Each element with its depth, until its parent takes it.
        let mut built: Vec<Option<(Element, usize)>> = Vec::new();
        for WrittenElement { name, attributes, children, drag } in written.elements {
            let mut depth = 1;
            let children = children.into_iter().map(|child| match child {
                WrittenChild::Text(text) => Ok(Child::Text(text)),
                WrittenChild::Element(number) => {
                    let inner = built.get_mut(number as usize).and_then(Option::take);
                    let (inner, inner_depth) = inner.ok_or("an element of the scene without a place")?;
                    depth = depth.max(inner_depth + 1);
                    Ok(Child::Element(inner))
                }
            });
            let children = children.collect::<Result<_, Self::Error>>()?;
            if depth > DEEPEST {
                return Err("a scene that is nested too deeply");
            }
            built.push(Some((Element { name, attributes, children, drag }, depth)));
        }
        let (root, _) = built.pop().flatten().ok_or("a scene without elements")?;
        if built.iter().any(Option::is_some) {
            return Err("an element of the scene without a place");
        }
        Ok(Self { root, values: written.values, trails: written.trails, length: written.length })
    }
}
