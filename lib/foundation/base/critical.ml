let depth = ref 0
let active () = !depth > 0
let enter () = incr depth
let leave () = decr depth

let run f =
  enter ();
  match f () with
  | x ->
    leave ();
    x
  | exception e ->
    leave ();
    raise e
