open Scc_exact

type relation = Less | At_most | Equal
type t = { normal : Z.t array; relation : relation; right : Z.t }

let first_nonzero a =
  let rec from i = if i >= Array.length a then None else if Z.sign a.(i) <> 0 then Some i else from (i + 1) in
  from 0

let gcd_of normal right =
  let rec from i g = if i < 0 || Z.equal g Z.one then g else from (i - 1) (Z.gcd g normal.(i)) in
  from (Array.length normal - 1) (Z.abs right)

(* Copies nothing that is in its one form already. *)
let normalised normal relation right =
  let g = gcd_of normal right in
  let backwards =
    relation = Equal
    &&
    match first_nonzero normal with
    | Some i -> Z.sign normal.(i) < 0
    | None -> Z.sign right < 0
  in
  if Z.sign g = 0 || (Z.equal g Z.one && not backwards) then { normal; relation; right }
  else
    let by = if backwards then Z.neg g else g in
    { normal = Array.map (fun a -> Z.divexact a by) normal; relation; right = Z.divexact right by }

let make normal relation right = normalised (Array.copy normal) relation right

let of_form (f : Linear.t) relation =
  Effort.spend (Linear.dimension f);
  let common = Array.fold_left (fun d a -> Z.lcm d (Q.den a)) (Q.den f.constant) f.coefficients in
  let scaled a = Z.mul (Q.num a) (Z.divexact common (Q.den a)) in
  normalised (Array.map scaled f.coefficients) relation (Z.neg (scaled f.constant))

let less f g = of_form (Linear.sub f g) Less
let at_most f g = of_form (Linear.sub f g) At_most
let greater f g = less g f
let at_least f g = at_most g f
let equals f g = of_form (Linear.sub f g) Equal
let dimension c = Array.length c.normal

let to_form c =
  Linear.make ~constant:(Q.of_bigint (Z.neg c.right)) (Array.map Q.of_bigint c.normal)

let first_variable c = first_nonzero c.normal

let holds relation sign =
  match relation with
  | Less -> sign < 0
  | At_most -> sign <= 0
  | Equal -> sign = 0

let truth c =
  match first_variable c with
  | Some _ -> None
  | None -> Some (holds c.relation (-Z.sign c.right))

let mem c point =
  if Array.length point <> dimension c then Scc_base.Bug.fail __POS__ "a point of another dimension";
  let sum = ref Rat.zero in
  let add i a = if Z.sign a <> 0 then sum := Rat.add !sum (Rat.mul (Q.of_bigint a) point.(i)) in
  Array.iteri add c.normal;
  holds c.relation (Rat.compare !sum (Q.of_bigint c.right))

let mentions c i = Z.sign c.normal.(i) <> 0

let compare_normals c d =
  let rec from i =
    if i >= dimension c then 0
    else
      let order = Z.compare c.normal.(i) d.normal.(i) in
      if order <> 0 then order else from (i + 1)
  in
  Int.compare (dimension c) (dimension d) <?> fun () -> from 0

let rank = function Equal -> 0 | Less -> 1 | At_most -> 2

(* The direction without the common factor that the right side may have kept in. *)
let direction c =
  let g = gcd_of c.normal Z.zero in
  if Z.sign g = 0 || Z.equal g Z.one then c.normal else Array.map (fun a -> Z.divexact a g) c.normal

let same_normal c d =
  let p = direction c and q = direction d in
  Array.length p = Array.length q && Array.for_all2 Z.equal p q

let compare_directions c d =
  let p = { c with normal = direction c } and q = { d with normal = direction d } in
  compare_normals p q

let compare c d =
  let order = Bool.compare (d.relation = Equal) (c.relation = Equal) in
  if order <> 0 then order
  else
    let order = compare_directions c d in
    if order <> 0 then order
    else
      (* b/g against b'/g', where g and g' are the common factors of the normals *)
      let g = gcd_of c.normal Z.zero and h = gcd_of d.normal Z.zero in
      Z.compare (Z.mul c.right h) (Z.mul d.right g) <?> fun () ->
        Int.compare (rank c.relation) (rank d.relation) <?> fun () -> Z.compare c.right d.right

let equal c d = c == d || (c.relation = d.relation && Z.equal c.right d.right && compare_normals c d = 0)

(* Positive p and q with p c.normal = q d.normal, or -q d.normal: [Some (p, q, along)]. Stops at the first
   coefficient that shows that there are none. Zero is an immediate value, as all small numbers of Zarith are. *)
let multiples c d =
  let a = c.normal and b = d.normal in
  let n = Array.length a in
  let rec first i =
    if i >= n then None
    else if a.(i) == Z.zero && b.(i) == Z.zero then first (i + 1)
    else
      match (Z.sign a.(i), Z.sign b.(i)) with
      | 0, _ | _, 0 -> None
      | s, s' ->
        let along = s = s' in
        let p = Z.abs b.(i) and q = if along then Z.abs a.(i) else Z.neg (Z.abs a.(i)) in
        let rec rest j = j >= n || (Z.equal (Z.mul p a.(j)) (Z.mul q b.(j)) && rest (j + 1)) in
        if rest (i + 1) then Some (p, Z.abs q, along) else None
  in
  first 0

type glance = Follows | Implies | Excludes | Unrelated

(* The bounds as those of one normal: n.x <= p c.right, and n.x <= q d.right or n.x >= -q d.right. *)
let glance c d =
  if c.relation = Equal || d.relation = Equal then if equal c d then Follows else Unrelated
  else
    match multiples c d with
    | None -> Unrelated
    | Some (p, q, true) ->
      let order = Z.compare (Z.mul q d.right) (Z.mul p c.right) in
      if order < 0 || (order = 0 && (c.relation = At_most || d.relation = Less)) then Follows else Implies
    | Some (p, q, false) ->
      let room = Z.sign (Z.add (Z.mul p c.right) (Z.mul q d.right)) in
      if room < 0 || (room = 0 && (c.relation = Less || d.relation = Less)) then Excludes else Unrelated
let opposite c relation = { normal = Array.map Z.neg c.normal; relation; right = Z.neg c.right }

let halves c =
  match c.relation with
  | Less | At_most -> [ c ]
  | Equal -> [ { c with relation = At_most }; opposite c At_most ]

let negation c =
  match c.relation with
  | Less -> [ opposite c At_most ]
  | At_most -> [ opposite c Less ]
  | Equal -> [ { c with relation = Less }; opposite c Less ]

let strict c = if c.relation = At_most then { c with relation = Less } else c
let closed c = if c.relation = Less then { c with relation = At_most } else c
let tight c = normalised c.normal Equal c.right

(* p c + q d *)
let combination p c q d relation =
  let mix a b = Z.add (Z.mul p a) (Z.mul q b) in
  normalised (Array.map2 mix c.normal d.normal) relation (mix c.right d.right)

let eliminate c i ~by =
  let a = by.normal.(i) in
  if Z.sign a = 0 || by.relation <> Equal then Scc_base.Bug.fail __POS__ "the equality does not give the variable";
  if not (mentions c i) then c
  else
    let factor = if Z.sign a > 0 then Z.neg c.normal.(i) else c.normal.(i) in
    combination (Z.abs a) c factor by c.relation

let resolve c d i =
  let p = c.normal.(i) and q = d.normal.(i) in
  if Z.sign p * Z.sign q >= 0 then Scc_base.Bug.fail __POS__ "bounds from one side";
  let relation = if c.relation = Less || d.relation = Less then Less else At_most in
  combination (Z.abs q) c (Z.abs p) d relation

let rename c ~dimension:n at =
  let normal = Array.make n Z.zero in
  Array.iteri (fun i a -> if Z.sign a <> 0 then normal.(at.(i)) <- Z.add normal.(at.(i)) a) c.normal;
  normalised normal c.relation c.right

let substitute c ~dimension forms = of_form (Linear.compose (to_form c) ~dimension forms) c.relation
