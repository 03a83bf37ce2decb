(* Rule Lot against what it says by itself: at a split instant each bond draws, whatever the others do, and in
   whatever order those that are to be released are released, each order alike, a bond stays whose leaf has no
   more to offer. Here all draws, and all orders, are gone through one by one. *)

open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Scc_test_networks
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(** What a leaf offers, and what comes of it when it has released a bond. *)
type kind =
  | Again of Rat.t  (** with this chance, and offers it again *)
  | Once of Rat.t  (** and offers nothing more *)
  | Either of Rat.t * Rat.t
  (** with the one chance, and offers nothing more; with the other, and offers it again *)
  | Free  (** without a chance, again *)
  | Free_once
  | Nothing

type tree = { kinds : kind array; up : int array  (** of each leaf but the first, the one that it is bound to *) }

(* {1 By the rule book} *)

(* The definitions are those of the leaves, and a last one that offers nothing. *)
let surface =
  let faces = List.init 6 (fun f -> Feature.Face f) in
  let sites = List.map (fun feature : Site.t -> { part = 0; feature }) in
  Behaviour.channel ~name:"a" ~sites:(sites faces) ~closure:(sites (Polyhedron.closure Cube.polyhedron faces)) ()

let definitions kinds : Behaviour.definitions =
  let nothing = Behaviour.call (Array.length kinds) in
  let body i = function
    | Again q -> Behaviour.weak ~odds:(Chance q) surface (Behaviour.call i)
    | Once q -> Behaviour.weak ~odds:(Chance q) surface nothing
    | Either (q, r) ->
      Behaviour.(sum (weak ~odds:(Chance q) surface nothing) (weak ~odds:(Chance r) surface (call i)))
    | Free -> Behaviour.weak surface (Behaviour.call i)
    | Free_once -> Behaviour.weak surface nothing
    | Nothing -> Behaviour.nil
  in
  let definition i kind : Behaviour.definition = { name = Printf.sprintf "B%d" i; body = body i kind } in
  Array.append (Array.mapi definition kinds) [| { name = "Nothing"; body = Behaviour.nil } |]

let model kinds : Model.t =
  let solid = Solid.make ~id:0 Cube.polyhedron Mat.identity in
  let leaf i _ : Model.leaf =
    let name = Printf.sprintf "p%d" i in
    let part : Model.part =
      { name; template = "Cube"; solid; offset = Vec.zero; open_offset = None; mass = Rat.one }
    in
    {
      name; template = "Cube"; parts = [| part |]; fixed = false; absorbs = false; mass = Rat.one; law = Inertial;
      law_at = Scc_base.Span.none;
    }
  in
  {
    leaves = Array.mapi leaf kinds;
    definitions = definitions kinds;
    timestep = Rat.one;
    splits = Every Rat.one;
    ranges = [||];
    keeps_time = false;
    steered = false;
    steps = Shared;
    collisions = In_turn;
    binding = On_collision;
    bonds = Acyclic;
    blocked = Bounce;
    lots = true;
    round_velocity = None;
    rigid = None;
  }

(* Bonds need not touch here: who lets go does not depend on it. *)
let bond tree i : State.bond =
  let finish at face : State.finish = { at; site = { part = 0; feature = Face face } } in
  State.bond "a" (finish tree.up.(i) (i mod 6)) (finish i ((i + 3) mod 6))

let bonds tree = List.init (Array.length tree.kinds - 1) (fun i -> bond tree (i + 1))

let whole tree =
  let leaf i _ : State.leaf =
    {
      leaf = i; position = Vec.of_ints (3 * i) 0 0; turned = Quaternion.identity; waited = Rat.zero;
      behaviour = Behaviour.fresh (Behaviour.call i);
    }
  in
  let leaves = Array.to_list (Array.mapi leaf tree.kinds) in
  State.make
    ~processes:[ State.process ~leaves ~bonds:(bonds tree) ~velocity:Vec.zero ~clock:None () ]
    ~step:None ~time:None

(* What is told of the end: which bonds are left, and which leaves have nothing more to offer. *)
type result = { left : State.bond list; spent : int list }

let compare_result a b =
  match List.compare State.compare_bond a.left b.left with 0 -> List.compare Int.compare a.spent b.spent | c -> c

let result n (s : State.t) =
  let processes = Array.to_list s.processes in
  let leaves = List.concat_map (fun (p : State.process) -> Array.to_list p.leaves) processes in
  let spent (l : State.leaf) = if Behaviour.equal l.behaviour.term (Behaviour.call n) then Some l.leaf else None in
  {
    left =
      List.sort State.compare_bond
        (List.concat_map (fun (p : State.process) -> Array.to_list p.bonds) processes);
    spent = List.sort Int.compare (List.filter_map spent leaves);
  }

let total chances =
  let add kept (r, c) =
    match kept with
    | (s, d) :: rest when compare_result r s = 0 -> (s, Rat.add c d) :: rest
    | _ -> (r, c) :: kept
  in
  List.fold_left add [] (List.sort (fun (r, _) (s, _) -> compare_result r s) chances) |> List.rev

let by_rules tree =
  let m = model tree.kinds in
  let c = standard m in
  let n = Array.length tree.kinds in
  let ok = function Ok x -> x | Error _ -> failwith "chances sum to more than 1" in
  let rec from s chance =
    if Lots.pending s then
      List.concat_map
        (fun (t : Transition.t) -> from t.target (Rat.mul chance (Transition.chance t.label)))
        (ok (Network.successors c s))
    else [ (result n s, chance) ]
  in
  let s = ok (Network.initial c (whole tree)) in
  (* bonds that both ends release freely may split at once; what is looked at is what time brings *)
  match List.find_opt (fun (t : Transition.t) -> Transition.is_time t.label) (ok (Network.successors c s)) with
  | Some t -> total (from t.target Rat.one)
  | None -> [ (result n s, Rat.one) ]

(* {1 One by one} *)

(* What an end may draw: nothing, or that it lets go, and whether it is spent then; and whether it has a chance. *)
let draws = function
  | Again q -> ([ (Some false, q); (None, Rat.sub Rat.one q) ], true)
  | Once q -> ([ (Some true, q); (None, Rat.sub Rat.one q) ], true)
  | Either (q, r) ->
    ([ (Some true, q); (Some false, r); (None, Rat.sub Rat.one (Rat.add q r)) ], true)
  | Free -> ([ (Some false, Rat.one) ], false)
  | Free_once -> ([ (Some true, Rat.one) ], false)
  | Nothing -> ([ (None, Rat.one) ], false)

(* Each bond: not released, or by ends that are spent then or not. *)
let lots tree i =
  let one, has_one = draws tree.kinds.(tree.up.(i)) and two, has_two = draws tree.kinds.(i) in
  if not (has_one || has_two) then [ (None, Rat.one) ]
  else
    List.concat_map
      (fun (a, q) ->
         List.map
           (fun (b, r) ->
              let both = match (a, b) with Some a, Some b -> Some (a, b) | None, _ | _, None -> None in
              (both, Rat.mul q r))
           two)
      one

let rec orders = function
  | [] -> [ [] ]
  | list ->
    List.concat_map (fun x -> List.map (fun rest -> x :: rest) (orders (List.filter (fun y -> y <> x) list))) list

(* In an order, by whoever is not spent yet. *)
let released tree order =
  let spent = Array.make (Array.length tree.kinds) false in
  let go gone (i, (one, two)) =
    if spent.(tree.up.(i)) || spent.(i) then gone
    else begin
      if one then spent.(tree.up.(i)) <- true;
      if two then spent.(i) <- true;
      i :: gone
    end
  in
  let gone = List.fold_left go [] order in
  let left = List.filteri (fun k _ -> not (List.mem (k + 1) gone)) (bonds tree) in
  let indices = List.init (Array.length spent) Fun.id in
  { left = List.sort State.compare_bond left; spent = List.filter (fun i -> spent.(i)) indices }

let one_by_one tree =
  let n = Array.length tree.kinds in
  let rec all i drawn chance =
    if Rat.sign chance = 0 then []
    else if i = n then
      let every = orders (List.rev drawn) in
      let each = Rat.div chance (Rat.of_int (List.length every)) in
      List.map (fun order -> (released tree order, each)) every
    else
      List.concat_map
        (fun (lot, q) ->
           let drawn = match lot with Some ends -> (i, ends) :: drawn | None -> drawn in
           all (i + 1) drawn (Rat.mul chance q))
        (lots tree i)
  in
  total (all 1 [] Rat.one)

(* {1 At random} *)

let chance = Gen.map (fun n -> Rat.make (Z.of_int n) (Z.of_int 7)) (Gen.int_range 0 7)
let part = Gen.map (fun n -> Rat.make (Z.of_int n) (Z.of_int 7)) (Gen.int_range 1 3)

let kind =
  let open Gen in
  frequency
    [
      (2, map (fun q -> Again q) part); (3, map (fun q -> Once q) chance);
      (2, map2 (fun q r -> Either (q, r)) part part); (2, pure Free); (2, pure Free_once); (1, pure Nothing);
    ]

let tree =
  let open Gen in
  let* n = int_range 2 5 in
  let* kinds = array_repeat n kind in
  let+ ups = flatten_l (List.init (n - 1) (fun i -> int_range 0 i)) in
  { kinds; up = Array.of_list (0 :: ups) }

let print tree =
  let q = Rat.to_string in
  let kind = function
    | Again p -> "again " ^ q p
    | Once p -> "once " ^ q p
    | Either (p, r) -> Printf.sprintf "either %s %s" (q p) (q r)
    | Free -> "free"
    | Free_once -> "free once"
    | Nothing -> "nothing"
  in
  Array.to_list tree.kinds
  |> List.mapi (fun i k -> Printf.sprintf "%d on %d: %s" i tree.up.(i) (kind k))
  |> String.concat "; "

let same a b =
  List.equal (fun (r, c) (s, d) -> compare_result r s = 0 && Rat.equal c d) a b

let independent =
  QCheck2.Test.make ~name:"Lot: bonds are independent" ~count:300 ~print tree (fun tree ->
      same (by_rules tree) (one_by_one tree))

(* So that it is about something: that a bond stays which was to be released comes up. *)
let conflicts () =
  let rand = Random.State.make [| 42 |] in
  let in_conflict tree =
    let n = Array.length tree.kinds in
    let count s = n - 1 - List.length s.left in
    let every = List.concat_map (lots tree) (List.init (n - 1) succ) in
    let could = List.length (List.filter (fun (lot, q) -> lot <> None && Rat.sign q > 0) every) in
    could > List.fold_left (fun most (r, _) -> max most (count r)) 0 (by_rules tree)
  in
  let trees = Gen.generate ~rand ~n:100 tree in
  Alcotest.(check bool) "some" true (List.length (List.filter in_conflict trees) > 10)

let suite =
  ("lots",
   [
     ("Lot", Scc_test_support.Property.cases [ independent ]);
     ("scope", [ Alcotest.test_case "bonds that cannot all go" `Quick conflicts ]);
   ])
