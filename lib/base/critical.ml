let depth = ref 0
let active () = !depth > 0

let run f =
  incr depth;
  match f () with
  | x ->
    decr depth;
    x
  | exception e ->
    decr depth;
    raise e
