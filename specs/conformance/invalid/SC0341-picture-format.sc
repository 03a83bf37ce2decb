// a drawing with a stroke
