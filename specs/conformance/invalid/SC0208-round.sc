// a rounding that is no power of two
dynamics free_body
round orientation 1/1000
