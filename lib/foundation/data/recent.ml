type 'a t = {
  number : 'a -> int;
  none : 'a;
  most : int;
  mutable slots : 'a array;
  mutable kept : int;  (** since it was made so large *)
}

let first_size = 1 lsl 10

let create ~number ~none ~most =
  { number; none; most; slots = Array.make (Int.min most first_size) none; kept = 0 }

let get t number = Array.unsafe_get t.slots (number land (Array.length t.slots - 1))

let put t slots x = slots.(t.number x land (Array.length slots - 1)) <- x

(* Made to the end before it takes the place of the old one: work may be given up anywhere. *)
let enlarge t =
  let slots = Array.make (2 * Array.length t.slots) t.none in
  Array.iter (fun x -> if x != t.none then put t slots x) t.slots;
  t.slots <- slots;
  t.kept <- 0

let keep t x =
  if t.kept >= Array.length t.slots && Array.length t.slots < t.most then enlarge t;
  put t t.slots x;
  t.kept <- t.kept + 1
