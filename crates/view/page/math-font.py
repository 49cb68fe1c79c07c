"""Makes math.woff2 from NewCMMath-Regular.otf; see math-font.txt. Needs fonttools and brotli:

    python3 math-font.py NewCMMath-Regular.otf math.woff2
"""

import sys

from fontTools import subset
from fontTools.ttLib import TTFont

# Latin, Greek, digits, the accents of Spanish, and the signs that physics at school and university needs.
CHARACTERS = [
    (0x20, 0x21), (0x25, 0x25), (0x28, 0x3E), (0x41, 0x5B), (0x5D, 0x5D), (0x61, 0x7D), (0xA0, 0xA0), (0xAC, 0xAC),
    (0xB0, 0xB1), (0xB5, 0xB5), (0xB7, 0xB7), (0xD7, 0xD7), (0xE1, 0xE1), (0xE9, 0xE9), (0xED, 0xED), (0xF1, 0xF1),
    (0xF3, 0xF3), (0xFA, 0xFA), (0x393, 0x394), (0x398, 0x398), (0x39B, 0x39B), (0x3A0, 0x3A0), (0x3A3, 0x3A3),
    (0x3A6, 0x3A6), (0x3A8, 0x3A9), (0x3C0, 0x3C0), (0x2026, 0x2026), (0x2032, 0x2034), (0x2057, 0x2057),
    (0x2190, 0x2190), (0x2192, 0x2192), (0x2202, 0x2202), (0x210E, 0x210E), (0x2212, 0x2212), (0x221A, 0x221A),
    (0x221E, 0x221E), (0x2227, 0x2228), (0x2248, 0x2248), (0x2260, 0x2260), (0x2264, 0x2265), (0x22C5, 0x22C5),
    (0x2308, 0x230B), (0x27F9, 0x27F9), (0x1D434, 0x1D467), (0x1D6FC, 0x1D71B),
]
# What grows with what it encloses, and to how many sizes before it is put together from pieces.
GROWING = {"parenleft", "parenright", "braceleft", "braceright", "bracketleft", "bracketright", "bar", "radical"}
SIZES = 5

font = TTFont(sys.argv[1])

variants = font["MATH"].table.MathVariants
glyphs, constructions = [], []
for glyph, construction in zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction):
    if glyph in GROWING:
        construction.MathGlyphVariantRecord = construction.MathGlyphVariantRecord[:SIZES]
        construction.VariantCount = len(construction.MathGlyphVariantRecord)
        glyphs.append(glyph)
        constructions.append(construction)
variants.VertGlyphCoverage.glyphs = glyphs
variants.VertGlyphConstruction = constructions
variants.VertGlyphCount = len(constructions)
variants.HorizGlyphCoverage, variants.HorizGlyphConstruction, variants.HorizGlyphCount = None, [], 0

# The primes of text are raised already, and formulas raise them again. The variants for exponents stand on the line.
for table in font["cmap"].tables:
    for code, glyph in ((0x2032, "minute"), (0x2033, "uni2033"), (0x2034, "uni2034"), (0x2057, "uni2057")):
        if code in table.cmap:
            table.cmap[code] = glyph + ".st"

options = subset.Options()
options.layout_features = []
options.hinting = False
options.desubroutinize = True
options.drop_tables += ["DSIG", "FFTM", "GDEF", "GSUB", "GPOS"]
options.name_IDs = [0, 1, 2, 4, 6, 13, 14]
subsetter = subset.Subsetter(options)
subsetter.populate(unicodes=[code for first, last in CHARACTERS for code in range(first, last + 1)])
subsetter.subset(font)

# The licence asks for another name.
NAMES = {1: "Meniscus Math", 4: "Meniscus Math, a part of New Computer Modern Math", 6: "MeniscusMath-Regular"}
for record in font["name"].names:
    record.string = NAMES.get(record.nameID, record.string)
outlines = font["CFF "].cff
outlines.fontNames = [NAMES[6]]
outlines.topDictIndex[0].FamilyName = outlines.topDictIndex[0].FullName = NAMES[1]

font.flavor = "woff2"
font.save(sys.argv[2])
