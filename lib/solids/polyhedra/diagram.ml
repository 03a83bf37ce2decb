open Scc_exact

module type Value = sig
  type t

  val equal : t -> t -> bool
  val hash : t -> int
  val any : t
  val compose : t -> dimension:int -> Linear.t array -> t
end

type operation = Restrict | First | Add | Least | Greatest | Ends
type 'v cut = One of 'v option | Cut of Constraint.t * 'v * 'v

module type S = sig
  type value
  type space
  val space : unit -> space
  type t
  val constant : space -> value -> t
  val nowhere : space -> t
  val within : space -> Constraint.t list -> t -> t
  val first : space -> t -> t -> t
  val combine : space -> operation -> (value option -> value option -> value option) -> t -> t -> t
  val combine_cutting : space -> operation -> (value option -> value option -> value cut) -> t -> t -> t
  val map : space -> (value -> value) -> t -> t
  val preimage : space -> dimension:int -> Linear.t array -> Polyhedron.t -> t -> t
  val pieces : Polyhedron.t -> t -> (Polyhedron.t * value option) list
end

(* [normal].x < [bound], or <= [bound] if not [strict]. The normal is a number of the space: its coefficients are
   integers without a common factor, the first of which is positive. *)
type atom = { normal : int; form : Z.t array; bound : Rat.t; strict : bool }

module Make (V : Value) = struct
  type value = V.t

  (* Along each path atoms are in the order of {!compare_atoms}. Where an atom holds, all later ones of its normal
     do: none of them follows. *)
  type t = { id : int; node : node }
  and node = Leaf of V.t option | Test of atom * t * t

  let equal_atom a b = Int.equal a.normal b.normal && Rat.equal a.bound b.bound && Bool.equal a.strict b.strict

  let compare_atoms a b =
    Int.compare a.normal b.normal
    <?> (fun () -> Rat.compare a.bound b.bound)
    <?> fun () -> Bool.compare b.strict a.strict

  module Values = Hashtbl.Make (struct
      type t = V.t option
      let equal = Option.equal V.equal
      let hash = function None -> 0 | Some v -> V.hash v
    end)

  module Tests = Hashtbl.Make (struct
      type t = atom * int * int
      let equal (a, yes, no) (b, yes', no') = Int.equal yes yes' && Int.equal no no' && equal_atom a b
      let hash (a, yes, no) = (((((Rat.hash a.bound * 31) + a.normal) * 31) + yes) * 31) + no
    end)

  module Pairs = Hashtbl.Make (struct
      type t = int * int
      let equal (f, g) (f', g') = Int.equal f f' && Int.equal g g'
      let hash (f, g) = (f * 65599) + g
    end)

  type space = {
    normals : (string, int) Hashtbl.t;
    leaves : t Values.t;
    tests : t Tests.t;
    results : (operation * t Pairs.t) list;
    mutable made : int;
  }

  let space () =
    {
      normals = Hashtbl.create 64;
      leaves = Values.create 64;
      tests = Tests.create 1024;
      results = List.map (fun o -> (o, Pairs.create 64)) [ Restrict; First; Add; Least; Greatest; Ends ];
      made = 0;
    }

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
        if positive then test s a yes no else test s a no yes)

  (* {1 Operations} *)

  let rec past normal t =
    match t.node with Test (a, yes, _) when Int.equal a.normal normal -> past normal yes | Test _ | Leaf _ -> t

  (* What is left of a diagram where an atom holds, and where it does not, that comes no later than its first. *)
  let branches a t =
    match t.node with
    | Test (b, yes, no) when equal_atom a b -> (yes, no)
    | Test _ | Leaf _ -> (past a.normal t, t)

  (* [yes] where the atom holds, and [no] elsewhere. *)
  let choose s a yes no =
    let known = Pairs.create 16 in
    let is_before t = match t.node with Leaf _ -> true | Test (b, _, _) -> compare_atoms a b <= 0 in
    let rec go yes no =
      let key = (yes.id, no.id) in
      match Pairs.find_opt known key with
      | Some t -> t
      | None ->
        let t = if yes == no then no else made yes no in
        Pairs.add known key t;
        t
    and made yes no =
      match (yes.node, no.node) with
      | _ when is_before yes && is_before no -> test s a (fst (branches a yes)) (snd (branches a no))
      | Test (b, _, _), Test (c, _, _) -> by (if compare_atoms b c <= 0 then b else c) yes no
      | Test (b, _, _), Leaf _ | Leaf _, Test (b, _, _) -> by b yes no
      | Leaf _, Leaf _ -> Scc_base.Bug.fail __POS__ "a value comes after no test"
    (* An atom that comes before. *)
    and by b yes no =
      let yes_yes, yes_no = branches b yes and no_yes, no_no = branches b no in
      test s b (if Int.equal b.normal a.normal then yes_yes else go yes_yes no_yes) (go yes_no no_no)
    in
    go yes no

  let memo (table : (int, _) Hashtbl.t) key make =
    match Hashtbl.find_opt table key with
    | Some x -> x
    | None ->
      let x = make () in
      Hashtbl.add table key x;
      x

  let put_together s ~on operation of_values =
    let results = List.assoc operation s.results in
    let rec apply f g =
      let key = (f.id, g.id) in
      match Pairs.find_opt results key with
      | Some t -> t
      | None ->
        let t =
          match (f.node, g.node) with
          | Leaf v, Leaf w -> of_values v w
          | Test (a, _, _), Leaf _ | Leaf _, Test (a, _, _) -> first_by a f g
          | Test (a, _, _), Test (b, _, _) -> first_by (if compare_atoms a b <= 0 then a else b) f g
        in
        Pairs.add results key t;
        t
    and first_by a f g =
      let f_yes, f_no = branches a f and g_yes, g_no = branches a g in
      on s a (apply f_yes g_yes) (apply f_no g_no)
    in
    apply

  let combine s operation of_values = put_together s ~on:test operation (fun v w -> leaf s (of_values v w))

  let combine_cutting s operation of_values =
    let divided c yes no =
      match Constraint.truth c with
      | Some true -> yes
      | Some false -> no
      | None ->
        let a, positive = atom s c in
        if positive then choose s a yes no else choose s a no yes
    in
    let of_cut = function
      | One v -> leaf s v
      | Cut (c, yes, no) -> divided c (leaf s (Some yes)) (leaf s (Some no))
    in
    put_together s ~on:choose operation (fun v w -> of_cut (of_values v w))

  let restrict s = combine s Restrict (fun guard v -> match guard with Some _ -> v | None -> None)

  let within s constraints f =
    let guard region c = restrict s (guard_half s (constant s V.any) c) region in
    List.fold_left guard f (List.concat_map Constraint.halves constraints)

  let first s = combine s First (fun v w -> match v with Some _ -> v | None -> w)

  let map s of_value f =
    let seen = Hashtbl.create 64 in
    let rec go t = memo seen t.id (fun () -> of_node t.node)
    and of_node = function
      | Leaf v -> leaf s (Option.map of_value v)
      | Test (a, yes, no) -> test s a (go yes) (go no)
    in
    go f

  (* {1 Other variables} *)

  (* A form of atoms over other variables: a number, or [by] times the form of other atoms, and a number. *)
  type moved = Number of Rat.t | Form of { normal : int; form : Z.t array; by : Rat.t; plus : Rat.t }

  let moved s ~dimension forms form =
    let all = Linear.make ~constant:Rat.zero (Array.map Q.of_bigint form) in
    let all = Linear.compose all ~dimension forms in
    if Linear.is_constant all then Number all.constant
    else
      let a, _ = atom s (Constraint.of_form all Less) in
      let i = Option.get (Constraint.first_variable (to_constraint a)) in
      let by = Rat.div (Linear.coefficient all i) (Q.of_bigint a.form.(i)) in
      Form { normal = a.normal; form = a.form; by; plus = all.constant }

  let below a x =
    let order = Rat.compare x a.bound in
    if a.strict then order < 0 else order <= 0

  (* Whether an atom holds everywhere or nowhere between two ends. *)
  let on_all a (least, most) =
    let holds = function
      | Some (Polyhedron.Bound { value; attained }) -> below { a with strict = a.strict && attained } value
      | Some Unbounded | None -> false
    in
    let fails = function
      | Some (Polyhedron.Bound { value; attained }) ->
        not (below { a with strict = a.strict || not attained } value)
      | Some Unbounded | None -> false
    in
    if holds most then Some true else if fails least then Some false else None

  let preimage s ~dimension forms set =
    let ends = Hashtbl.create 8 and moves = Hashtbl.create 8 and seen = Hashtbl.create 64 in
    let ends_of a () =
      let f = Linear.make ~constant:Rat.zero (Array.map Q.of_bigint a.form) in
      (Polyhedron.infimum set f, Polyhedron.supremum set f)
    in
    let rec go t =
      match t.node with
      | Leaf None -> t
      | Leaf (Some v) -> leaf s (Some (V.compose v ~dimension forms))
      | Test (a, yes, no) -> memo seen t.id (on a yes no)
    and on a yes no () =
      match on_all a (memo ends a.normal (ends_of a)) with
      | Some holds -> go (if holds then yes else no)
      | None -> (
          match memo moves a.normal (fun () -> moved s ~dimension forms a.form) with
          | Number x -> go (if below a x then yes else no)
          | Form { normal; form; by; plus } ->
            let bound = Rat.div (Rat.sub a.bound plus) by in
            if Rat.sign by > 0 then choose s { a with normal; form; bound } (go yes) (go no)
            else choose s { normal; form; bound; strict = not a.strict } (go no) (go yes))
    in
    go

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
end
