// a picture of a hundred megapixels
