// a drawing with text
