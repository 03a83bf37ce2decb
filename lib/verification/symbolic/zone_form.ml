open Scc_exact
open Scc_polyhedra
open Scc_offsets
open Scc_calculus
open Scc_state_sets
open Zone

let centred z =
  match List.concat_map State.members (Array.to_list z.skeleton.processes) with
  | [] -> z
  | first :: _ as leaves ->
    let origin = z.places.(first) in
    let places = Array.copy z.places in
    List.iter (fun leaf -> places.(leaf) <- Place.sub places.(leaf) origin) leaves;
    { z with places }

let renamed z image =
  let by_image of_old =
    let fresh = Array.copy of_old in
    Array.iteri (fun leaf other -> fresh.(other) <- of_old.(leaf)) image;
    fresh
  in
  let clocks = Array.copy z.clocks in
  let rename (p : State.process) =
    let fresh = State.renamed (fun leaf -> image.(leaf)) p in
    (fresh, fresh.leaves.(0).leaf, z.clocks.(p.leaves.(0).leaf))
  in
  let all = List.map rename (Array.to_list z.skeleton.processes) in
  let none = Linear.constant (dimension z) Rat.zero in
  Array.fill clocks 0 (Array.length clocks) none;
  List.iter (fun (_, first, clock) -> clocks.(first) <- clock) all;
  let processes = List.map (fun (p, _, _) -> p) all in
  let skeleton = State.make ~processes ~step:z.skeleton.step ~time:z.skeleton.time in
  { z with skeleton; clocks; ages = by_image z.ages; places = by_image z.places }

(* {1 The canonical form} *)

(* Each variable, where the equalities of a polyhedron hold, by variables that none of them gives. *)
let free_variables set =
  let n = Polyhedron.dimension set in
  let forms = Array.init n (Linear.variable n) in
  let give c =
    match Constraint.first_variable c with
    | None -> ()
    | Some i ->
      let f = Constraint.to_form c in
      let a = Linear.coefficient f i in
      forms.(i) <- Linear.sub (Linear.variable n i) (Linear.scale (Rat.div Rat.one a) f)
  in
  List.iter give (Polyhedron.equalities set);
  forms

(* A number that is given by the coordinates that were chosen: [of_old] is equal to [of_new]. The old variable
   [pivot] occurs in it with the coefficient 1, and in no row that was made later. *)
type row = { pivot : int; of_old : Linear.t; of_new : Linear.t }

let first_occurring f =
  let rec find i =
    if i >= Linear.dimension f then None
    else if Rat.sign (Linear.coefficient f i) <> 0 then Some i
    else find (i + 1)
  in
  find 0

(* What is left of a form when all rows are taken off, and what was taken, in new variables. *)
let reduced n rows f =
  let take (rest, taken) row =
    let a = Linear.coefficient rest row.pivot in
    if Rat.sign a = 0 then (rest, taken)
    else (Linear.sub rest (Linear.scale a row.of_old), Linear.add taken (Linear.scale a row.of_new))
  in
  List.fold_left take (f, Linear.constant n Rat.zero) rows

(* The numbers of the coordinates that are chosen, and all coordinates by those: the i-th that was chosen is new
   variable i. Rows are in the order in which they were made. *)
let choose n coordinates =
  let add (rows, chosen, given) (number, f) =
    let rest, taken = reduced n rows f in
    match first_occurring rest with
    | None -> (rows, chosen, Linear.add taken (Linear.constant n rest.constant) :: given)
    | Some pivot ->
      let y = Linear.variable n (List.length chosen) in
      let by = Rat.div Rat.one (Linear.coefficient rest pivot) in
      let row =
        { pivot; of_old = Linear.scale by rest; of_new = Linear.scale by (Linear.sub y taken) }
      in
      (rows @ [ row ], number :: chosen, y :: given)
  in
  let numbered = Array.to_list (Array.mapi (fun i f -> (i, f)) coordinates) in
  let rows, chosen, given = List.fold_left add ([], [], []) numbered in
  (rows, Array.of_list (List.rev chosen), Array.of_list (List.rev given))

(* The old variables by the new ones, where these give them all: then nothing is to be projected out. *)
let inverse n rows free =
  let values = Array.make n None in
  let solve { pivot; of_old; of_new } =
    let take rest i =
      let a = Linear.coefficient of_old i in
      match (rest, values.(i)) with
      | Some rest, _ when i = pivot || Rat.sign a = 0 -> Some rest
      | Some rest, Some v -> Some (Linear.sub rest (Linear.scale a v))
      | Some _, None | None, _ -> None
    in
    let start = Linear.sub of_new (Linear.constant n of_old.constant) in
    values.(pivot) <- List.fold_left take (Some start) (List.init n Fun.id)
  in
  List.iter solve (List.rev rows);
  let known i = values.(i) <> None || not (Linear.equal free.(i) (Linear.variable n i)) in
  if List.for_all known (List.init n Fun.id) then
    let zero = Linear.constant n Rat.zero in
    let values = Array.map (fun v -> Option.value v ~default:zero) values in
    Some (Array.map (fun f -> Linear.compose f ~dimension:n values) free)
  else None

(* [given] has a form for each coordinate, in the order of {!coordinates}. *)
let of_coordinates z ~set ~basis given =
  let next = ref 0 in
  let take _ =
    incr next;
    given.(!next - 1)
  in
  let parameters = Array.map take z.parameters in
  let time = Option.map take z.time in
  let step = Option.map take z.step in
  let grid = Option.map take z.grid in
  let ages = Array.map take z.ages in
  let clocks = Array.map take z.clocks in
  let place (x, y, z) =
    let x = take x in
    let y = take y in
    (x, y, take z)
  in
  { z with set; basis; parameters; time; step; grid; ages; clocks; places = Array.map place z.places }

let canonical z =
  let n = dimension z in
  let free = free_variables z.set in
  let old = Array.map (fun f -> Linear.compose f ~dimension:n free) (coordinates z) in
  let rows, basis, given = choose n old in
  let m = Array.length basis in
  let forms = Array.map (fun i -> old.(i)) basis in
  (* Of the n variables that the forms are over, the first m occur. *)
  let trim = Array.init n (fun i -> if i < m then Linear.variable m i else Linear.constant m Rat.zero) in
  let given = Array.map (fun f -> Linear.compose f ~dimension:m trim) given in
  let set =
    match inverse n rows free with
    | Some old_by_new ->
      let by_new = Array.map (fun f -> Linear.compose f ~dimension:m trim) old_by_new in
      Polyhedron.preimage z.set ~dimension:m by_new
    | None -> Polyhedron.image z.set forms
  in
  let set = Polyhedron.minimal set in
  (of_coordinates z ~set ~basis given, forms)

(* {1 Comparing} *)

let same_kind a b =
  Bool.equal a.halted b.halted && List.equal Int.equal a.arrived b.arrived && State.equal a.skeleton b.skeleton

let hash_kind z = (((State.hash z.skeleton * 31) + Hashtbl.hash z.arrived) * 2) + Bool.to_int z.halted

let sample z =
  match Polyhedron.point z.set with
  | Some point -> Array.map (fun f -> Linear.eval f point) (coordinates z)
  | None -> Scc_base.Bug.fail __POS__ "an empty zone"

let has z values = Polyhedron.mem z.set (Array.map (fun i -> values.(i)) z.basis)

let same_forms a b =
  let same = Array.for_all2 Linear.equal in
  let same_place (x, y, z) (x', y', z') = Linear.equal x x' && Linear.equal y y' && Linear.equal z z' in
  Polyhedron.dimension a.set = Polyhedron.dimension b.set
  && Array.for_all2 Int.equal a.basis b.basis
  && same a.parameters b.parameters
  && List.for_all2 (Option.equal Linear.equal) [ a.time; a.step; a.grid ] [ b.time; b.step; b.grid ]
  && same a.ages b.ages && same a.clocks b.clocks
  && Array.for_all2 same_place a.places b.places

let included a b =
  let n = dimension a in
  if same_forms a b then
    if Polyhedron.included a.set b.set then Some (Array.init n (Linear.variable n)) else None
  else
    let of_a = coordinates a and of_b = coordinates b in
    let forms = Array.map (fun i -> of_a.(i)) b.basis in
    let agrees i f = Linear.equal (Linear.compose f ~dimension:n forms) of_a.(i) in
    let rec all i = i >= Array.length of_b || (agrees i of_b.(i) && all (i + 1)) in
    if all 0 && Polyhedron.included a.set (Polyhedron.preimage b.set ~dimension:n forms) then Some forms else None

let merged a b =
  if same_forms a b then Option.map (fun set -> { a with set }) (Envelope.merge a.set b.set) else None

let set_of (z : Zone.t) =
  let coordinates = Zone.coordinates z in
  let n = Array.length coordinates in
  let chosen = Array.map (Linear.variable n) z.basis in
  let given i f = Constraint.equals (Linear.variable n i) (Linear.compose f ~dimension:n chosen) in
  Polyhedron.add_all (Polyhedron.embed z.set ~dimension:n z.basis) (Array.to_list (Array.mapi given coordinates))
