//! The simulation document: one Markdown file with prose, equations, scene, plots, presets and questions.
