// Formulas a little smaller than MathJax would have them, so that they go with the letters around them.
MathJax.Hub.Config({ SVG: { scale: 88 }, showMathMenu: false, messageStyle: "none" });
