open Scc_exact
open Scc_polyhedra
open Scc_calculus

(* {1 Numbers} *)

let about x =
  let text = Decimal.significant ~digits:4 x in
  (* "about 1" would be taken for certain *)
  if text = "1" && Rat.compare x Rat.one < 0 then "more than 0.9999" else "about " ^ text

let number x =
  let text = Rat.to_string x in
  if Rat.is_integer x then text
  else
    match Decimal.exact x with
    | Some decimal -> text ^ " = " ^ decimal
    | None -> text ^ ", " ^ about x

(* A long end of an interval is rounded outwards. *)
let longest = 48
let is_long x = String.length (Rat.to_string x) > longest
let low_end x = if is_long x then Decimal.rounded_down ~places:6 x else number x
let high_end x = if is_long x then Decimal.rounded_up ~places:6 x else number x

let probability = function
  | Where.Exactly x -> number x
  | Between (low, high) -> "at least " ^ number low ^ ", and at most " ^ number high
  | Not_computed -> Printf.sprintf "not computed: a piece has more than %d corners" Volume.most_corners

(* {1 Pieces} *)

(* The constraints that the box, with the other ones, does not imply; those that the box alone implies go first. *)
let beyond box constraints =
  let rec needed kept = function
    | [] -> List.rev kept
    | c :: rest ->
      if Polyhedron.implies (Polyhedron.add_all box (List.rev_append kept rest)) c then needed kept rest
      else needed (c :: kept) rest
  in
  needed [] (List.filter (fun c -> not (Polyhedron.implies box c)) constraints)

type side = { form : Linear.t; above : bool; bound : Rat.t; strict : bool }

(* An inequality as a bound of a form in integers without a common factor, the first of which is positive. *)
let side (c : Constraint.t) =
  let first = c.normal.(Option.get (Constraint.first_variable c)) in
  let common = Array.fold_left Z.gcd Z.zero c.normal in
  let scale = if Z.sign first < 0 then Z.neg common else common in
  let coefficients = Array.map (fun a -> Rat.make a scale) c.normal in
  {
    form = Linear.make ~constant:Rat.zero coefficients;
    above = Z.sign first > 0;
    bound = Rat.make c.right scale;
    strict = c.relation = Less;
  }

let between ~name low high =
  let relation s = if s.strict then " < " else " <= " in
  String.concat ""
    [ Rat.to_string low.bound; relation low; Text.form ~name low.form; relation high; Rat.to_string high.bound ]

let rec texts ~name told = function
  | [] -> List.rev told
  | (c : Constraint.t) :: rest when c.relation = Equal -> texts ~name (Text.constraint_ ~name c :: told) rest
  | c :: rest -> (
      let s = side c in
      let opposite (d : Constraint.t) =
        d.relation <> Equal
        &&
        let t = side d in
        t.above <> s.above && Linear.equal t.form s.form
      in
      match List.partition opposite rest with
      | [ d ], others ->
        let t = side d in
        let low, high = if s.above then (t, s) else (s, t) in
        texts ~name (between ~name low high :: told) others
      | _ -> texts ~name (Text.constraint_ ~name c :: told) rest)

(* Equalities, then what speaks of one variable, then of more. *)
let simplest_first constraints =
  let key (c : Constraint.t) =
    let variables = List.filter (fun a -> Z.sign a <> 0) (Array.to_list c.normal) in
    if c.relation = Equal then 0 else List.length variables
  in
  List.stable_sort (fun c d -> Int.compare (key c) (key d)) constraints

let piece ranges p =
  match simplest_first (beyond (Ranges.box ranges) (Polyhedron.constraints p)) with
  | [] -> "everywhere"
  | constraints -> String.concat ", " (texts ~name:(Ranges.name ranges) [] constraints)

let without_extent = function
  | 1 -> "no length"
  | 2 -> "no area"
  | _ -> "no volume"

(* {1 Reports} *)

let listed ranges u =
  let n = Array.length ranges in
  let line i p =
    let extent = if Polyhedron.affine_dimension p < n then " (" ^ without_extent n ^ ")" else "" in
    (if i = 0 then "  " else "  or ") ^ piece ranges p ^ extent
  in
  List.mapi line (Union.pieces u)

let told ranges name u = (name ^ " where") :: listed ranges u

(* {1 Functions} *)

let not_known = "not known"

let value ranges (v : Chances.value) =
  let form = Text.form ~name:(Ranges.name ranges) in
  match (v.least, v.most) with
  | None, _ -> "infinite"
  | Some least, Some most when Linear.equal least most -> form least
  | Some least, Some most -> Printf.sprintf "from %s to %s, not known better" (form least) (form most)
  | Some least, None -> Printf.sprintf "at least %s, not known better" (form least)

let mean c =
  match Chances.mean c with
  | Not_computed -> "mean not computed"
  | Not_known share -> Printf.sprintf "mean not known: nothing is known for a share of %s" (number share)
  | Between { low = None; _ } -> "mean infinite"
  | Between { low = Some low; high = Some high } when Rat.equal low high -> "mean " ^ number low
  | Between { low = Some low; high = Some high } ->
    Printf.sprintf "mean at least %s, and at most %s" (low_end low) (high_end high)
  | Between { low = Some low; high = None } -> Printf.sprintf "mean at least %s" (low_end low)

let chances (c : Chances.t) =
  let whole = Ranges.to_string c.ranges in
  let everywhere = Chances.known_everywhere c in
  let for_ = if whole = "" then "" else ", for " ^ whole in
  let for_ = if everywhere then for_ else " where it is known" ^ for_ in
  let with_mean text = if everywhere then text else text ^ "; " ^ mean c in
  match (c.parts, Chances.extremes c) with
  | [ _ ], { low = Some least; high = Some most } when Rat.equal least most -> with_mean (number least ^ for_)
  | [ { value = v; _ } ], _ -> with_mean (value c.ranges v ^ for_)
  | _, { low = None; _ } -> "infinite" ^ for_
  | _, { low = Some low; high = Some high } ->
    Printf.sprintf "%s to %s%s; %s" (Rat.to_string low) (Rat.to_string high) for_ (mean c)
  | _, { low = Some low; high = None } ->
    let known = List.for_all (fun (p : Chances.part) -> Chances.is_known p.value) c.parts in
    let format = if known then format_of_string "%s to infinite%s; %s" else "at least %s%s; %s" in
    Printf.sprintf format (Rat.to_string low) for_ (mean c)

let chances_lines (c : Chances.t) =
  let n = Array.length c.ranges in
  let line told p =
    let extent = if Polyhedron.affine_dimension p < n then " (" ^ without_extent n ^ ")" else "" in
    Printf.sprintf "%s%s: %s" (piece c.ranges p) extent told
  in
  let of_part (part : Chances.part) = List.map (line (value c.ranges part.value)) (Union.pieces part.set) in
  List.concat_map of_part c.parts @ List.map (line not_known) (Union.pieces c.unknown) @ [ mean c ]

let sets (w : Where.t) =
  let none u = Union.is_empty u and count u = List.length (Union.pieces u) in
  let told = told w.ranges in
  if none w.unknown then
    if none w.fails then [ "holds everywhere" ]
    else if none w.holds then [ "fails everywhere" ]
    else if count w.holds <= count w.fails then told "holds" w.holds @ [ "fails elsewhere" ]
    else told "fails" w.fails @ [ "holds elsewhere" ]
  else if none w.holds && none w.fails then [ "not known anywhere" ]
  else
    (if none w.holds then [ "not known to hold anywhere" ] else told "holds" w.holds)
    @ (if none w.fails then [ "not known to fail anywhere" ] else told "fails" w.fails)
    @ [ "not known elsewhere" ]

let lines (w : Where.t) =
  let chance = Where.probability w in
  let remark =
    let is x = match chance with Exactly y -> Rat.equal x y | Between _ | Not_computed -> false in
    if is Rat.zero && not (Union.is_empty w.holds) then ", but not nowhere"
    else if is Rat.one && not (Union.is_empty w.fails) then ", but not everywhere"
    else if is Rat.one && not (Union.is_empty w.unknown) then ", but not known everywhere"
    else ""
  in
  sets w @ [ "probability " ^ probability chance ^ remark ]
