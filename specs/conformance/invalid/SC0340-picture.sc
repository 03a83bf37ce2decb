// a picture of six pixels that has four
