// two pieces
