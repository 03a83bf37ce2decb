// a picture in which nothing is drawn
