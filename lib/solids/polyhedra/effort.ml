exception Exhausted

let left = ref max_int

let spend n =
  left := !left - n;
  if !left < 0 then raise Exhausted

let within ~most f =
  let outside = !left in
  let given = Int.min most outside in
  left := given;
  let leave () = left := outside - (given - Int.max 0 !left) in
  match f () with
  | x ->
    leave ();
    Some x
  | exception Exhausted ->
    leave ();
    None
  | exception e ->
    leave ();
    raise e
