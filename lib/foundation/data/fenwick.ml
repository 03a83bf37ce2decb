(* [sums.(i)], from 1 on, is the sum of the boxes from i - lowest_bit i to i - 1. *)
type t = { sums : int array; mutable total : int }

let create n = { sums = Array.make (n + 1) 0; total = 0 }
let total t = t.total
let lowest_bit i = i land -i

let add t box more =
  let rec from i =
    if i < Array.length t.sums then begin
      t.sums.(i) <- t.sums.(i) + more;
      from (i + lowest_bit i)
    end
  in
  from (box + 1);
  t.total <- t.total + more

let rec power_above n p = if p > n then p else power_above n (2 * p)

(* As many of the first boxes as hold no more than [k] things, by powers of two. *)
let find t k =
  if k < 0 || k >= t.total then Scc_base.Bug.fail __POS__ "there is no such thing in any box";
  let rec from before k step =
    if step = 0 then (before, k)
    else
      let next = before + step in
      if next < Array.length t.sums && t.sums.(next) <= k then from next (k - t.sums.(next)) (step / 2)
      else from before k (step / 2)
  in
  from 0 k (power_above (Array.length t.sums) 1)
