open Scc_exact
open Scc_calculus
open Scc_property
open Scc_test_networks
module Gen = QCheck2.Gen

let rational n d = Rat.make (Z.of_int n) (Z.of_int d)

(* {1 Networks of several clusters} *)

(* Two cubes that are born bound, above the first cluster. *)
type dimer = { x : int; speed : int  (** in halves *); behaviours : int * int }

type clusters = { networks : Random_network.t list; apart : int; dimers : dimer list; pulses : bool }

(* A cube of mass 1 that can move. *)
let cube_leaf network =
  let leaves = (Random_network.model (Random_network.with_bystanders network)).leaves in
  let leaf = leaves.(Array.length leaves - 1) in
  if leaf.fixed || Array.length leaf.parts > 1 then failwith "another leaf is wanted";
  leaf

let process_of_dimer ~first k d =
  (* left is the face number 2 of the cube, and right number 3 *)
  let face k : Site.t = { part = 0; feature = Scc_geometry.Feature.Face k } in
  let leaf i behaviour : State.leaf =
    let behaviour = Behaviour.fresh (Behaviour.call behaviour) in
    let position = Vec.of_ints (d.x + (2 * i)) (14 + (6 * k)) 0 in
    { leaf = first + i; position; turned = Quaternion.identity; waited = Rat.zero; behaviour }
  in
  let bond = State.bond "a" { at = first; site = face 3 } { at = first + 1; site = face 2 } in
  State.process
    ~leaves:[ leaf 0 (fst d.behaviours); leaf 1 (snd d.behaviours) ]
    ~bonds:[ bond ]
    ~velocity:(Vec.make Rat.zero (rational d.speed 2) Rat.zero)
    ~clock:None ()

(* Puts networks side by side, [apart] from each other along x, with one numbering of leaves. *)
let assemble c =
  let place (k, leaves, processes) network =
    let before = List.length leaves in
    let m = Random_network.model network in
    let named (l : Model.leaf) = { l with name = Printf.sprintf "c%d.%s" k l.name } in
    let shift = Vec.of_ints (k * c.apart) 0 0 in
    let moved (p : State.process) =
      let move (l : State.leaf) =
        let pulses = c.pulses && k > 0 && l.leaf mod 2 = 0 in
        let behaviour = if pulses then Behaviour.fresh (Behaviour.call 9) else l.behaviour in
        let position = Vec.add shift l.position in
        { State.leaf = before + l.leaf; position; turned = Quaternion.identity; waited = Rat.zero; behaviour }
      in
      State.process
        ~leaves:(List.map move (Array.to_list p.leaves))
        ~bonds:[] ~velocity:p.velocity ~clock:None ()
    in
    let declared = Array.to_list (Random_network.declared network).processes in
    (k + 1, leaves @ List.map named (Array.to_list m.leaves), processes @ List.map moved declared)
  in
  let first = List.hd c.networks in
  let _, leaves, processes = List.fold_left place (0, [], []) c.networks in
  let before = List.length leaves in
  let cubes k _ =
    List.map (fun i -> { (cube_leaf first) with name = Printf.sprintf "d%d.%d" k i }) [ 0; 1 ]
  in
  let dimer k d = process_of_dimer ~first:(before + (2 * k)) k d in
  let leaves = leaves @ List.concat (List.mapi cubes c.dimers) in
  let processes = processes @ List.mapi dimer c.dimers in
  let m = { (Random_network.model first) with leaves = Array.of_list leaves; keeps_time = true } in
  (m, Reach.initial m (State.make ~processes ~step:None ~time:None))

let dimer =
  let open Gen in
  let+ x = 0 -- 10 and+ speed = -4 -- 4 and+ behaviours = oneofl [ (1, 3); (6, 8); (12, 1); (6, 6) ] in
  { x; speed; behaviours }

let clusters =
  let open Gen in
  let network = frequency [ (2, Random_network.generate ()); (1, Random_network.absorbing ()) ] in
  let* networks = list_size (1 -- 3) network in
  let* apart = oneofl [ 14; 16; 20; 40 ] and* bystanders = map (fun n -> n = 0) (0 -- 4) in
  let* dimers = list_size (0 -- 2) dimer and* pulses = bool in
  let add networks =
    match List.rev networks with
    | last :: (_ :: _ as rest) when bystanders -> List.rev (Random_network.with_bystanders last :: rest)
    | _ -> networks
  in
  pure { networks = add networks; apart; dimers; pulses }

(* {1 Searches over the leaves of the first cluster} *)

let atom leaves : Property.prop Gen.t =
  let open Gen in
  let leaf = 0 -- (leaves - 1) and number = map (fun n -> Property.Const (rational n 2)) (-8 -- 20) in
  let comparison = oneofl Law.[ Lt; Le; Gt; Ge; Eq; Ne ] in
  let compare n =
    let* n = n and* c = comparison and* k = number in
    pure (Property.Compare (c, n, k))
  in
  let axis = oneofl Property.[ X; Y; Z ] and pair = pair leaf leaf in
  let two make = map (fun (i, j) -> if i = j then Property.Bool true else make i j) pair in
  oneof
    [
      compare (map2 (fun a i -> Property.Quantity (Position (a, i))) axis leaf);
      compare (map2 (fun a i -> Property.Quantity (Velocity (a, i))) axis leaf);
      compare (map (fun i -> Property.Quantity (Size i)) leaf);
      compare (map (fun (i, j) -> Property.Quantity (Distance2 (i, j))) pair);
      compare (map (fun (i, j) -> Property.Quantity (Bonds (None, Some (i, j)))) pair);
      compare (pure (Property.Quantity Time));
      two (fun i j -> Property.Fact (Touching (i, j)));
      two (fun i j -> Property.Fact (Bound (i, j)));
      two (fun i j -> Property.Fact (Same (i, j)));
      map2 (fun i k -> Property.Fact (Behaviour (i, k))) leaf (0 -- 4);
      map (fun i -> Property.Fact (Offers (i, None, "a"))) leaf;
      map (fun i -> Property.Fact (Event (Bounce (One i)))) leaf;
      map (fun i -> Property.Fact (Event (Absorbed (One i)))) leaf;
      map (fun i -> Property.Fact (Gone i)) leaf;
      map (fun i -> Property.Fact (Event (Bond (Made, None, One i)))) leaf;
      map (fun i -> Property.Fact (Event (Bond (Released, None, One i)))) leaf;
    ]

let predicate leaves =
  let open Gen in
  let atoms = list_size (1 -- 3) (atom leaves) in
  let* list = atoms and* all = bool and* negated = map (fun n -> n = 0) (0 -- 3) in
  let p : Property.prop = if all then And list else Or list in
  let p = if negated then Property.Not p else p in
  (* Else much is decided at the start. *)
  let+ later = 0 -- 6 in
  if later > 3 then p else Property.And [ Compare (Gt, Quantity Time, Const (rational later 3)); p ]

let search leaves : Property.temporal Gen.t =
  let open Gen in
  let* p = predicate leaves and* halves = 0 -- 6 and* bounded = map (fun n -> n > 0) (0 -- 3) in
  let bound = { Property.low = Rat.zero; high = (if bounded then Some (rational halves 2) else None) } in
  oneofl Property.[ Finally (Exists, bound, State p); Globally (All, bound, State p) ]

let formula leaves : Property.temporal Gen.t =
  let open Gen in
  let* f = search leaves and* g = search leaves in
  frequencyl [ (6, f); (1, Property.Temporal_and [ f; g ]); (1, Temporal_not (Temporal_or [ f; g ])) ]

type question = { clusters : clusters; formula : Property.temporal }

let question =
  let open Gen in
  let* clusters = clusters in
  let first = List.hd clusters.networks in
  let+ formula = formula (Array.length (Random_network.model first).leaves) in
  { clusters; formula }

let print q =
  let m, _ = assemble q.clusters in
  let dimer d =
    let one, two = d.behaviours in
    Printf.sprintf " (x %d, speed %d/2, %d and %d)" d.x d.speed one two
  in
  Printf.sprintf "%s\napart %d%s, dimers%s\n%s"
    (Show.temporal m q.formula)
    q.clusters.apart
    (if q.clusters.pulses then ", pulses" else "")
    (String.concat "" (List.map dimer q.clusters.dimers))
    (String.concat "\n--\n" (List.map Random_network.print q.clusters.networks))
