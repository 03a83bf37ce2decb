let place ?(nth = 0) text piece =
  let n = String.length piece in
  let rec look i nth =
    if i + n > String.length text then Alcotest.failf "there is no `%s`" piece
    else if String.sub text i n = piece then if nth = 0 then i else look (i + 1) (nth - 1)
    else look (i + 1) nth
  in
  look 0 nth
