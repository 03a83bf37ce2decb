(* Without roots at the ends, which are often multiple, and do not matter. *)
let rec without p x =
  if Polynomial.degree p >= 1 && Polynomial.sign_at p x = 0 then
    without (fst (Polynomial.divide p (Polynomial.of_coefficients [ Rat.neg x; Rat.one ]))) x
  else p

let inside p ~low ~high = Polynomial.primitive (without (without p low) high)

let simple p ~low ~high =
  if Polynomial.degree p < 1 then []
  else
    List.map
      (fun root -> Bernstein.to_algebraic root ~scale:Rat.one ~shift:Rat.zero)
      (Bernstein.roots p ~low ~high)

let all p ~low ~high =
  if Polynomial.is_zero p then Scc_base.Bug.fail __POS__ "the zero polynomial has no isolated roots"
  else simple (Polynomial.square_free (inside p ~low ~high)) ~low ~high

let changes p ~low ~high =
  if Polynomial.is_zero p then [] else simple (Polynomial.odd_part (inside p ~low ~high)) ~low ~high
