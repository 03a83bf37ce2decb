type t = True | False | Undecided of string

let of_bool b = if b then True else False
let not_ = function True -> False | False -> True | Undecided r -> Undecided r

let and_ a b =
  match (a, b) with
  | False, _ | _, False -> False
  | True, x | x, True -> x
  | Undecided r, Undecided _ -> Undecided r

let or_ a b = not_ (and_ (not_ a) (not_ b))

let equal a b =
  match (a, b) with
  | True, True | False, False -> true
  | Undecided r, Undecided s -> String.equal r s
  | (True | False | Undecided _), _ -> false

let to_string = function True -> "true" | False -> "false" | Undecided r -> "undecided: " ^ r
