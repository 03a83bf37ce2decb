// U+0085 is a control character, and no end of a line: 
shape C = box(1, 1, 1)
