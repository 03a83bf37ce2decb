(* Rule Blocked: walks with exclusion. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
module Gen = QCheck2.Gen

let standard = Scc_engine.Standard.of_model

(* {1 Random walks} *)

let shapes =
  {|compound Ell {
  part foot : box(1,1,1) mass 1
  part back : box(1,1,1) mass 1 at translate (0,1,0)
  part toe : box(1,1,1) mass 1 at translate (1,0,0)
  glue foot.back ~ back.front
  glue foot.right ~ toe.left
}
compound Bar {
  part one : box(1,1,1) mass 1
  part two : box(1,1,1) mass 1 at translate (1,0,0)
  glue one.right ~ two.left
}
shape Wedge {
  vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1) e (1,0,1) f (0,1,1)
  faces low [a,c,b] high [d,e,f] front [a,b,e,d] left [a,d,f,c] slope [b,c,f,e]
}
|}

(* A kind of body, how far it is from the middle of its first square, in halves, and the squares that it takes. *)
let kinds =
  [
    ("box(1,1,1) mass 1", (0, 0, 0), [ (0, 0) ]);
    ("box(2,2,1) mass 3", (1, 1, 0), [ (0, 0); (1, 0); (0, 1); (1, 1) ]);
    ("Bar", (0, 0, 0), [ (0, 0); (1, 0) ]);
    ("Ell", (0, 0, 0), [ (0, 0); (1, 0); (0, 1) ]);
    ("Wedge mass 2", (-1, -1, -1), [ (0, 0) ]);
  ]

(* Symmetric: with each velocity its opposite, of the same weight. *)
let laws =
  [
    "choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }";
    "choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0), (0,0,0) weight 3 }";
    "choose { (1,0,0), (-1,0,0) }";
    "choose { (1,1,0), (-1,-1,0), (1,0,0) weight 2, (-1,0,0) weight 2 }";
    "choose { (2,0,0), (-2,0,0), (0,1,0), (0,-1,0) }";
    "choose { (1/2,0,0), (-1/2,0,0), (0,1,0), (0,-1,0) }";
    "choose { (1/2,1/3,0), (-1/2,-1/3,0), (0,3,0), (0,-3,0) }";
  ]

type floor = { columns : int; rows : int }

let squares (x, y) = List.map (fun (i, j) -> (x + i, y + j))

let fits floor taken places =
  let inside (x, y) = x >= 0 && y >= 0 && x < floor.columns && y < floor.rows in
  List.for_all (fun place -> inside place && not (List.mem place taken)) places

let placed name (dx, dy, dz) (x, y) =
  Printf.sprintf "%s at translate (%d/2, %d/2, %d/2)" name ((2 * x) + dx) ((2 * y) + dy) dz

let walls floor =
  let bar name (x, y) (w, h) =
    Printf.sprintf "fixed %s = box(%d, %d, 1) at translate (%d/2, %d/2, 0)\n" name w h x y
  in
  let c = floor.columns and r = floor.rows in
  bar "west" (-2, r - 1) (1, r + 2) ^ bar "east" (2 * c, r - 1) (1, r + 2)
  ^ bar "south" (c - 1, -2) (c, 1) ^ bar "north" (c - 1, 2 * r) (c, 1)

let walk_gen =
  let open Gen in
  let* floor =
    oneofl
      [
        { columns = 3; rows = 3 }; { columns = 3; rows = 2 }; { columns = 5; rows = 1 };
        { columns = 4; rows = 2 };
      ]
  in
  let* wanted = 2 -- 3 in
  let rec bodies i ~tries taken text =
    if i >= wanted || (i > 0 && tries = 0) then return text
    else
      let* name, shift, takes = frequencyl (List.mapi (fun i kind -> ((if i = 0 then 5 else 1), kind)) kinds) in
      let* x = 0 -- (floor.columns - 1) and* y = 0 -- (floor.rows - 1) and* law = oneofl laws in
      let places = squares (x, y) takes in
      if not (fits floor taken places) then bodies i ~tries:(tries - 1) taken text
      else
        let body = Printf.sprintf "process w%d = %s [nil]\nmotion w%d = %s\n" i (placed name shift (x, y)) i law in
        bodies (i + 1) ~tries (places @ taken) (text ^ body)
  in
  let+ bodies = bodies 0 ~tries:20 [] "" and+ timestep = oneofl [ "1"; "1"; "1/2"; "2" ] in
  Printf.sprintf "timestep %s steady\n" timestep ^ shapes ^ walls floor ^ bodies

(* {1 The chain of steps} *)

let load how text =
  let e = Scc_test_models.Load.exactly (Scc_test_models.Load.text ("blocked " ^ how ^ "\n" ^ text)) in
  (standard e.model, e.declared)

let places (s : State.t) =
  List.map (fun (l : State.leaf) -> Vec.to_string l.position) (State.leaves s) |> String.concat " "

let successors c s =
  match Network.successors c s with Ok transitions -> transitions | Error _ -> failwith "a law has no value"

(* The states after one step, each with its probability. All that is not drawn has one way to go on. *)
let step c s =
  let rec go chance s found =
    match Steer.next_to_draw c s with
    | None -> on chance s found
    | Some _ -> draws chance s found
  and draws chance s found =
    let add found (t : Transition.t) = go (Rat.mul chance (Transition.chance t.label)) t.target found in
    List.fold_left add found (successors c s)
  and on chance s found =
    match successors c s with
    | [ { Transition.label = Time d; target; _ } ] ->
      if not (Rat.equal d (Semantics.model c).timestep) then failwith "something is met within a step";
      (target, chance) :: found
    | _ -> failwith "there is no one way to go on"
  in
  go Rat.one s []

(* {1 Detailed balance} *)

module Places = Map.Make (String)

let most_states = 60

(* All places that can be reached, up to a bound, each with the chances of those that follow. *)
let chain c start =
  let add reached (s, _) = if Places.mem (places s) reached then reached else Places.add (places s) s reached in
  let chances steps =
    let add known (s, chance) =
      Places.update (places s) (fun before -> Some (Rat.add chance (Option.value before ~default:Rat.zero))) known
    in
    List.fold_left add Places.empty steps
  in
  let rec go todo reached known =
    match todo with
    | [] -> known
    | _ when Places.cardinal known >= most_states -> known
    | s :: rest ->
      let steps = step c s in
      let fresh = List.filter (fun (s, _) -> not (Places.mem (places s) reached)) steps in
      let come = List.fold_left add Places.empty fresh in
      let reached = Places.union (fun _ s _ -> Some s) reached come in
      go (rest @ List.map snd (Places.bindings come)) reached (Places.add (places s) (chances steps) known)
  in
  go [ start ] (Places.singleton (places start) start) Places.empty

let seen = ref 0

(* With equal chances both ways, the uniform distribution stays as it is: as much comes to a place as leaves it. *)
let is_symmetric known =
  let chance x y = Option.value ~default:Rat.zero (Places.find_opt y (Places.find x known)) in
  let both x y _ =
    (not (Places.mem y known))
    ||
    (incr seen;
     Rat.equal (chance x y) (chance y x))
  in
  Places.for_all (fun x after -> Places.for_all (both x) after) known

let start how text =
  let c, declared = load how text in
  match Network.initial c declared with Ok s -> (c, s) | Error _ -> failwith "a law has no value"

let balanced =
  QCheck2.Test.make ~name:"Blocked: detailed balance" ~count:40 ~print:Fun.id walk_gen (fun text ->
      let c, s = start "wait" text in
      is_symmetric (chain c s))

let some_seen () = if !seen < 500 then Alcotest.failf "only %d pairs of places" !seen

(* {1 By itself} *)

(* Nothing goes on for ever within an instant, and nothing is left free. *)
let no_jam =
  QCheck2.Test.make ~name:"Blocked: what stops goes on" ~count:40 ~print:Fun.id walk_gen (fun text ->
      let c, s = start "stop" text in
      let rec steps k s =
        match successors c s with
        | [ { Transition.label = Time _; target; _ } ] -> k = 0 || steps (k - 1) target
        | { label = Draw _; _ } :: _ as draws ->
          List.for_all (fun (t : Transition.t) -> steps k t.target) draws
        | _ -> false
      in
      steps 1 s)

let walker name x law =
  Printf.sprintf "process %s = box(1,1,1) mass 1 at translate (%d, 0, 0) [nil]\nmotion %s = choose { %s }\n" name x
    name law

let rec drawn c s =
  match successors c s with
  | [ { Transition.label = Draw _; target; _ } ] -> drawn c target
  | _ -> s

let rec bounced c s =
  match successors c s with
  | [ { Transition.label = Bounce _; target; _ } ] -> target
  | [ { target; _ } ] -> bounced c target
  | _ -> failwith "there is no one way to go on"

(* The velocities along a row of six places. *)
let velocities ?(at = drawn) how bodies =
  let row = walls { columns = 6; rows = 1 } in
  let c, s = start how (String.concat "" ("timestep 1 steady\n" :: shapes :: row :: bodies)) in
  let velocity (p : State.process) =
    if Option.is_none (State.mass (Semantics.model c) p) then None else Some (Rat.to_string p.velocity.x)
  in
  String.concat " " (List.filter_map velocity (Array.to_list (at c s).processes))

let ball = "process ball = box(1,1,1) mass 1 velocity (2, 0, 0) at translate (0, 0, 0) [nil]\n"

let by_cases () =
  let check ?at what expected how bodies = Alcotest.(check string) what expected (velocities ?at how bodies) in
  let right = "(1,0,0)" and left = "(-1,0,0)" in
  check "a train moves" "1 1 1" "wait" [ walker "p" 0 right; walker "q" 1 right; walker "r" 2 right ];
  check "but not into a wall" "0 0 0" "wait" [ walker "p" 3 right; walker "q" 4 right; walker "r" 5 right ];
  check "a place for two is for none" "0 0" "wait" [ walker "p" 1 right; walker "q" 3 left ];
  check "nor is it for a third" "0 0 0" "wait" [ walker "p" 0 right; walker "q" 1 right; walker "r" 3 left ];
  check "two places are for two" "1 -1" "wait" [ walker "p" 1 right; walker "q" 4 left ];
  check "what is blocked on the way" "0" "wait" [ walker "p" 3 "(3,0,0)" ];
  check "is taken, to stop there" "3" "stop" [ walker "p" 3 "(3,0,0)" ];
  check "at once, there is nothing to take" "0 1" "stop" [ walker "p" 5 right; walker "q" 2 right ];
  check "what is hit goes on" "0 1" "stop" [ walker "p" 2 "(2,0,0)"; walker "q" 3 right ];
  check "two that run into each other stop" "0 0" "stop" [ walker "p" 2 right; walker "q" 3 left ];
  check "and bounce by default" "1 -1" "bounce" [ walker "p" 2 right; walker "q" 3 left ];
  check ~at:bounced "a ball bounces off a walker that moves" "-1 1/2" "stop" [ ball; walker "p" 2 "(1/2,0,0)" ]

let suite =
  ( "blocked",
    [
      ("Blocked", Scc_test_support.Property.cases [ balanced; no_jam ]);
      ( "cases",
        [
          Alcotest.test_case "pairs of places, many" `Quick some_seen;
          Alcotest.test_case "Blocked: rows" `Quick by_cases;
        ] );
    ] )
