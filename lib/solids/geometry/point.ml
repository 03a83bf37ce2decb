(* Both numbers share a word, so that a search copies and compares points as it does integers, and to hand them on
   costs nothing: no solid has 2^31 vertices. *)
type t = int

let bits = 31
let[@inline] make ~of_a ~of_b = (of_a lsl bits) lor of_b
let[@inline] of_a p = p lsr bits
let[@inline] of_b p = p land ((1 lsl bits) - 1)
let[@inline] equal (p : t) q = p = q
let none = -1
