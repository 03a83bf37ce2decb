open Scc_exact

type value = { least : Rat.t; most : Rat.t }

(* [normal].x < [bound], or <= [bound] if not [strict]. The normal is a number of the space: its coefficients are
   integers without a common factor, the first of which is positive. *)
type atom = { normal : int; form : Z.t array; bound : Rat.t; strict : bool }

(* Along each path atoms are in the order of {!compare_atoms}. Where an atom holds, all later ones of its normal
   do: none of them follows. *)
type t = { id : int; node : node }
and node = Leaf of value option | Test of atom * t * t

let equal_atom a b = Int.equal a.normal b.normal && Rat.equal a.bound b.bound && Bool.equal a.strict b.strict

let compare_atoms a b =
  Int.compare a.normal b.normal
  <?> (fun () -> Rat.compare a.bound b.bound)
  <?> fun () -> Bool.compare b.strict a.strict

module Values = Hashtbl.Make (struct
    type t = value option
    let equal = Option.equal (fun a b -> Rat.equal a.least b.least && Rat.equal a.most b.most)
    let hash = function None -> 0 | Some v -> (Rat.hash v.least * 31) + Rat.hash v.most + 1
  end)

module Atoms = Hashtbl.Make (struct
    type t = atom
    let equal = equal_atom
    let hash a = (((Rat.hash a.bound * 31) + a.normal) * 2) + Bool.to_int a.strict
  end)

module Tests = Hashtbl.Make (struct
    type t = atom * int * int
    let equal (a, yes, no) (b, yes', no') = Int.equal yes yes' && Int.equal no no' && equal_atom a b
    let hash (a, yes, no) = (((((Rat.hash a.bound * 31) + a.normal) * 31) + yes) * 31) + no
  end)

type operation = Restrict | First | Add | Least | Greatest | Ends

type space = {
  domain : Polyhedron.t;
  normals : (string, int) Hashtbl.t;
  known : bool option Atoms.t;  (** what is known of atoms on the domain *)
  leaves : t Values.t;
  tests : t Tests.t;
  results : (operation * int * int, t) Hashtbl.t;
  mutable made : int;
}

let space domain =
  {
    domain;
    normals = Hashtbl.create 64;
    known = Atoms.create 64;
    leaves = Values.create 64;
    tests = Tests.create 1024;
    results = Hashtbl.create 1024;
    made = 0;
  }

let dimension s = Polyhedron.dimension s.domain

(* {1 Nodes} *)

let fresh s node =
  s.made <- s.made + 1;
  { id = s.made; node }

let leaf s v =
  match Values.find_opt s.leaves v with
  | Some t -> t
  | None ->
    let t = fresh s (Leaf v) in
    Values.add s.leaves v t;
    t

let constant s v = leaf s (Some v)
let nowhere s = leaf s None

let test s a yes no =
  let is_needed =
    match no.node with
    | Test (b, yes', _) when Int.equal a.normal b.normal -> yes' != yes
    | Test _ | Leaf _ -> true
  in
  if yes == no || not is_needed then no
  else
    let key = (a, yes.id, no.id) in
    match Tests.find_opt s.tests key with
    | Some t -> t
    | None ->
      let t = fresh s (Test (a, yes, no)) in
      Tests.add s.tests key t;
      t

(* {1 Constraints} *)

let normal s form =
  let key = String.concat "," (List.map Z.to_string (Array.to_list form)) in
  match Hashtbl.find_opt s.normals key with
  | Some n -> n
  | None ->
    let n = Hashtbl.length s.normals in
    Hashtbl.add s.normals key n;
    n

let to_constraint a =
  let scale = Q.den a.bound in
  Constraint.make (Array.map (Z.mul scale) a.form) (if a.strict then Less else At_most) (Q.num a.bound)

let truth s a =
  if Array.length a.form <> Polyhedron.dimension s.domain then None
  else
    match Atoms.find_opt s.known a with
    | Some known -> known
    | None ->
      let c = to_constraint a in
      let known =
        if Polyhedron.implies s.domain c then Some true
        else if Polyhedron.is_empty (Polyhedron.add s.domain c) then Some false
        else None
      in
      Atoms.add s.known a known;
      known

(* A half-space as an atom, and whether it is where the atom holds: otherwise it is where that fails. *)
let atom s (c : Constraint.t) =
  match Constraint.first_variable c with
  | None -> Scc_base.Bug.fail __POS__ "a constraint without variables"
  | Some i ->
    let common = Array.fold_left Z.gcd Z.zero c.normal in
    let positive = Z.sign c.normal.(i) > 0 in
    let by = if positive then common else Z.neg common in
    let form = Array.map (fun a -> Z.divexact a by) c.normal in
    let strict = match c.relation with Less -> positive | At_most -> not positive | Equal -> false in
    ({ normal = normal s form; form; bound = Rat.make c.right by; strict }, positive)

let guard_half s yes (c : Constraint.t) =
  let no = nowhere s in
  match Constraint.truth c with
  | Some true -> yes
  | Some false -> no
  | None -> (
      let a, positive = atom s c in
      match truth s a with
      | Some holds -> if Bool.equal holds positive then yes else no
      | None -> if positive then test s a yes no else test s a no yes)

(* {1 Operations} *)

let rec past normal t =
  match t.node with Test (a, yes, _) when Int.equal a.normal normal -> past normal yes | Test _ | Leaf _ -> t

(* What is left of a diagram where an atom holds, and where it does not, that comes no later than its first. *)
let branches a t =
  match t.node with
  | Test (b, yes, no) when equal_atom a b -> (yes, no)
  | Test _ | Leaf _ -> (past a.normal t, t)

let combine s operation of_values =
  let rec apply f g =
    let key = (operation, f.id, g.id) in
    match Hashtbl.find_opt s.results key with
    | Some t -> t
    | None ->
      let t =
        match (f.node, g.node) with
        | Leaf v, Leaf w -> leaf s (of_values v w)
        | Test (a, _, _), Leaf _ | Leaf _, Test (a, _, _) -> on a f g
        | Test (a, _, _), Test (b, _, _) -> on (if compare_atoms a b <= 0 then a else b) f g
      in
      Hashtbl.add s.results key t;
      t
  and on a f g =
    let f_yes, f_no = branches a f and g_yes, g_no = branches a g in
    test s a (apply f_yes g_yes) (apply f_no g_no)
  in
  apply

let restrict s = combine s Restrict (fun guard v -> match guard with Some _ -> v | None -> None)
let zero = { least = Rat.zero; most = Rat.zero }

let within s constraints f =
  let guard region c = restrict s (guard_half s (constant s zero) c) region in
  List.fold_left guard f (List.concat_map Constraint.halves constraints)

let first s = combine s First (fun v w -> match v with Some _ -> v | None -> w)

let both of_values v w =
  match (v, w) with Some v, Some w -> Some (of_values v w) | None, _ | _, None -> None

let either of_values v w =
  match (v, w) with Some v, Some w -> Some (of_values v w) | v, None -> v | None, w -> w

let by_ends f v w = { least = f v.least w.least; most = f v.most w.most }
let add s = combine s Add (both (by_ends Rat.add))
let least s = combine s Least (either (by_ends Rat.min))
let greatest s = combine s Greatest (either (by_ends Rat.max))
let ends s = combine s Ends (both (fun v w -> { least = v.least; most = w.most }))

let map s of_value f =
  let seen = Hashtbl.create 64 in
  let rec go t =
    match Hashtbl.find_opt seen t.id with
    | Some u -> u
    | None ->
      let u =
        match t.node with
        | Leaf v -> leaf s (Option.map of_value v)
        | Test (a, yes, no) -> test s a (go yes) (go no)
      in
      Hashtbl.add seen t.id u;
      u
  in
  go f

let scale s k = map s (fun v -> { least = Rat.mul k v.least; most = Rat.mul k v.most })
let sum s terms = List.fold_left (fun all (k, f) -> add s all (scale s k f)) (constant s zero) terms

(* {1 Reading} *)

let pieces p f =
  let rec go found p t =
    match t.node with
    | Leaf v -> (p, v) :: found
    | Test (a, yes, no) ->
      let c = to_constraint a in
      let on t found c =
        let q = Polyhedron.add p c in
        if Polyhedron.is_empty q then found else go found q t
      in
      List.fold_left (on no) (on yes found c) (Constraint.negation c)
  in
  if Polyhedron.is_empty p then [] else List.rev (go [] p f)
