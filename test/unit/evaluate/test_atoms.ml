(* The table of atoms against what atoms mean: on random networks, each atom has the value that its row allows.
   Whatever a row does not name may be changed, and the value stays. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl
open Scc_evaluate
open Scc_test_networks

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

(* {1 All atoms over some leaves} *)

type atom = Quantity of Property.quantity | Fact of Property.fact

let axes = Property.[ X; Y; Z ]
let names = [ "a"; "b" ]
let changes = Property.[ Made; Released_weakly; Released_strongly; Released ]

let each list f = List.concat_map f list

let quantities leaves pairs : Property.quantity list =
  each (None :: List.map Option.some names) (fun name ->
      Property.Bonds (name, None) :: List.map (fun pair -> Property.Bonds (name, Some pair)) pairs)
  @ each leaves (fun i -> Property.[ Size i; Speed2 i; Spin2 i ])
  @ each leaves (fun i -> each axes (fun a -> Property.[ Position (a, i); Velocity (a, i); Spin (a, i) ]))
  @ each pairs (fun (i, j) -> [ Property.Distance2 (i, j) ])
  @ each axes (fun a -> Property.[ Momentum a; Angular a ])
  @ [ Processes; Energy; Time ]

let ends leaves pairs : Property.ends list =
  (Property.Any :: List.map (fun i -> Property.One i) leaves) @ List.map (fun (i, j) -> Property.Two (i, j)) pairs

let facts m leaves pairs : Property.fact list =
  let definitions = List.init (Array.length m.Model.definitions) Fun.id in
  each pairs (fun (i, j) -> Property.[ Bound (i, j); Same (i, j); Touching (i, j) ])
  @ each leaves (fun i -> List.map (fun k -> Property.Behaviour (i, k)) definitions)
  @ each leaves (fun i ->
      each names (fun a ->
          List.map (fun p -> Property.Offers (i, p, a)) [ None; Some Behaviour.Name; Some Co_name ]))
  @ each (ends leaves pairs) (fun e ->
      Property.Event (Bounce e)
      :: Event (Absorbed e)
      :: List.map (fun c -> Property.Event (Bond (c, Some "a", e))) changes)
  @ List.map (fun i -> Property.Gone i) leaves
  @ [ Quiescent ]

let atoms m =
  let leaves = List.init (Array.length m.Model.leaves) Fun.id in
  let pairs = each leaves (fun i -> List.map (fun j -> (i, j)) leaves) in
  List.map (fun q -> Quantity q) (quantities leaves pairs) @ List.map (fun f -> Fact f) (facts m leaves pairs)

let row = function
  | Quantity q -> Atom.quantity q
  | Fact f -> Atom.fact f

let renamed f = function
  | Quantity q -> Quantity (Atom.renamed_quantity f q)
  | Fact x -> Fact (Atom.renamed_fact f x)

let show m = function
  | Quantity q -> Show.num m (Quantity q)
  | Fact f -> Show.prop m (Fact f)

(* {1 Values} *)

(* As text, at an offset of what begins in a state. Bonds have been made, and nothing else has happened. *)
let value semantics s extent atom offset =
  let arrived : Property.event -> bool = function
    | Bond (Made, _, _) -> true
    | Bond _ | Bounce _ | Absorbed _ | Hit _ -> false
  in
  let trajectory = Trajectory.make ~arrived semantics s extent and offset = Algebraic.of_rat offset in
  match atom with
  | Quantity q -> Value.at (Timeline.at (Trajectory.num trajectory (Quantity q)) offset) offset
  | Fact f -> Truth.to_string (Timeline.at (Trajectory.prop trajectory (Fact f)) offset)

let now semantics s atom = value semantics s Timeline.Instant atom Rat.zero

(* {1 What a row allows} *)

let seven = Some (Rat.of_int 7)
let with_processes processes (s : State.t) = State.make ~processes ~step:s.step ~time:s.time
let at_time time (s : State.t) = State.make ~processes:(Array.to_list s.processes) ~step:s.step ~time
let by = Vec.make (Rat.make (Z.of_int 7) (Z.of_int 3)) Rat.one (Rat.of_int (-5))

let moved (s : State.t) =
  let move (l : State.leaf) = { l with position = Vec.add by l.position } in
  with_processes (List.map (State.map_leaves move) (Array.to_list s.processes)) s

let only leaves (s : State.t) =
  let stays p = List.exists (State.has_leaf p) leaves in
  with_processes (List.filter stays (Array.to_list s.processes)) s

let swapped = function
  | [ i; j ] -> fun k -> if k = i then j else if k = j then i else k
  | _ -> Fun.id

let quarters d = List.init 4 (fun k -> Rat.mul d (Rat.make (Z.of_int k) (Z.of_int 4)))

let claims semantics (s : State.t) passing atom =
  let row = row atom in
  let stays s atom' = String.equal (now semantics s atom) (now semantics s atom') in
  let same s' = String.equal (now semantics s atom) (now semantics s' atom) in
  let is_named =
    match row.scope with
    | Named -> true
    | Whole -> false
  in
  let along d =
    let value = value semantics s (Timeline.Lasts d) atom in
    match row.event with
    | None -> List.for_all (fun t -> String.equal (value Rat.zero) (value t)) (quarters d)
    | Some _ -> List.for_all (fun t -> Rat.sign t = 0 || String.equal "false" (value t)) (quarters d)
  in
  [
    ("time", Atom.depends_on Absolute_time row || same (at_time seven s));
    ("place", Atom.depends_on Absolute_place row || same (moved s));
    ("others", (not is_named) || same (only (Atom.leaves row) s));
    ("order", (not row.symmetric) || stays s (renamed (swapped (Atom.leaves row)) atom));
    ( "change",
      match passing with
      | Some d when Atom.steady ~rigid:(Option.is_some (Semantics.model semantics).rigid) row -> along d
      | Some _ | None -> true );
  ]

let passing (transitions : Transition.t list) =
  List.find_map
    (fun (t : Transition.t) -> match t.label with Time d -> Some d | _ -> None)
    transitions

let kept (m, start) =
  let m = { m with Model.keeps_time = true } in
  let semantics = standard m in
  List.for_all
    (fun (s, transitions) ->
       let s = at_time (Some Rat.one) s in
       List.for_all
         (fun atom ->
            match List.find_opt (fun (_, holds) -> not holds) (claims semantics s (passing transitions) atom) with
            | None -> true
            | Some (claim, _) -> QCheck2.Test.fail_reportf "%s: %s" (show m atom) claim)
         (atoms m))
    (Reach.states { m with keeps_time = false } start ~limit:3)

let straight =
  QCheck2.Test.make ~count:100 ~name:"atoms depend on nothing else than the table says"
    ~print:Random_network.print (Random_network.generate ()) (fun n -> kept (Random_network.start n))

let absorbing =
  QCheck2.Test.make ~count:60 ~name:"also where some are gone" ~print:Random_network.print
    (Random_network.absorbing ()) (fun n -> kept (Random_network.start n))

let turning =
  QCheck2.Test.make ~count:40 ~name:"also of bodies that turn" ~print:Random_rigid.print
    (Random_rigid.generate Random_rigid.anything) (fun n -> kept (Random_rigid.start n))

let suite =
  ("atoms", [ ("the table", Scc_test_support.Property.cases [ straight; absorbing; turning ]) ])
