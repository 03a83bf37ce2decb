(* Rules WeakSplit and StrongSplit against a brute force over all sets of bonds and all choices. *)

open Scc_exact
open Scc_calculus
open Scc_semantics
open Fixture

let standard = Scc_engine.Standard.of_model
module Gen = QCheck2.Gen

let faces = [| "left"; "right"; "top" |]

(* A random tree of bonds over cubes (where the cubes are is of no matter to a split), with behaviours that
   offer reactions and releases on random channels. *)
type tree = { behaviours : Behaviour.t list; bonds : (string * (int * string) * (int * string)) list }

let gen_name = Gen.oneofl [ "a"; "b" ]
let gen_face = Gen.map (fun i -> faces.(i)) (Gen.int_range 0 2)
let gen_faces = Gen.map2 (fun f g -> [ f; g ]) gen_face gen_face
let gen_entry = Gen.pair gen_name gen_faces

(* The entries for some of the bonds of a leaf, each as (name, face of the leaf): mostly all of them, in a
   random order, with a face more each, so that entries compete for bonds. *)
let gen_strong mine =
  let open Gen in
  let entry (name, face) = map (fun more -> (name, [ more; face ])) gen_face in
  let some = function [] -> pure [] | l -> map (fun k -> List.filteri (fun i _ -> i <> k) l) (int_range 0 5) in
  oneof [ pure mine; some mine ] >>= shuffle_l >>= fun chosen ->
  map
    (function [] -> nil | entries -> strong entries nil)
    (flatten_l (List.map entry chosen))

let gen_behaviour mine =
  let summand =
    Gen.oneof
      [
        gen_strong mine; gen_strong mine;
        Gen.map (fun l -> strong l nil) (Gen.list_size (Gen.int_range 1 3) gen_entry);
        Gen.map (fun (n, f) -> weak n f (open_ n f nil)) gen_entry;
      ]
  in
  Gen.map
    (function [] -> nil | s :: rest -> List.fold_left Behaviour.sum s rest)
    (Gen.list_size (Gen.int_range 1 3) summand)

(* With [rings] some bonds more, of leaves that no bond joins yet. *)
let gen_tree ?(rings = false) () =
  let open Gen in
  int_range 2 6 >>= fun n ->
  let bond i =
    map2
      (fun (parent, name) (f, g) -> (name, (parent, f), (i, g)))
      (pair (int_range 0 (Stdlib.( - ) i 1)) gen_name)
      (pair gen_face gen_face)
  in
  flatten_l (List.init (Stdlib.( - ) n 1) (fun i -> bond (Stdlib.( + ) i 1))) >>= fun bonds ->
  let leaf = int_range 0 (Stdlib.( - ) n 1) in
  let more = pair (pair leaf gen_name) (pair (pair gen_face gen_face) leaf) in
  list_size (if rings then int_range 1 4 else pure 0) more >>= fun more ->
  let add bonds ((i, name), ((f, g), j)) =
    let joins (_, (k, _), (l, _)) = (k = i && l = j) || (k = j && l = i) in
    if i = j || List.exists joins bonds then bonds else bonds @ [ (name, (i, f), (j, g)) ]
  in
  let bonds = List.fold_left add bonds more in
  let mine at =
    List.concat_map
      (fun (name, (i, f), (j, g)) ->
         (if i = at then [ (name, f) ] else []) @ if j = at then [ (name, g) ] else [])
      bonds
  in
  map
    (fun behaviours -> { behaviours; bonds })
    (flatten_l (List.init n (fun at -> gen_behaviour (mine at))))

let setup tree =
  let bodies =
    List.mapi
      (fun i behaviour -> body (Printf.sprintf "p%d" i) (Stdlib.( * ) 4 i, 0, 0) ~behaviour)
      tree.behaviours
  in
  let m = model bodies in
  (m, start m (joined bodies tree.bonds))

let rec powerset = function
  | [] -> [ [] ]
  | x :: rest ->
    let p = powerset rest in
    p @ List.map (fun s -> x :: s) p

let rec permutations = function
  | [] -> [ [] ]
  | l ->
    List.concat_map
      (fun x -> List.map (fun p -> x :: p) (permutations (List.filter (fun y -> not (y == x)) l)))
      l

(* The definition, read literally: X is not empty and connected; every leaf at an end of X chooses one rho
   whose entries match its bonds of X one to one. The number of choices for each X. *)
let brute_force (m : Model.t) (p : State.process) =
  let rhos (l : State.leaf) =
    List.filter_map
      (function Behaviours.Offer_strong (entries, _, _) -> Some entries | _ -> None)
      (Behaviours.offers m.definitions l.behaviour)
  in
  let ends (b : State.bond) = [ b.one.at; b.two.at ] in
  let rec hang_together reached rest =
    let near, far = List.partition (fun b -> List.exists (fun at -> List.mem at reached) (ends b)) rest in
    if near = [] then far = [] else hang_together (reached @ List.concat_map ends near) far
  in
  let connected = function [] -> false | b :: rest -> hang_together (ends b) rest in
  let site (b : State.bond) at = if b.one.at = at then b.one.site else b.two.site in
  let fits at (entry : Behaviour.channel) (b : State.bond) =
    String.equal entry.name b.name && Behaviour.active entry (site b at)
  in
  let matching at bonds entries =
    List.length bonds = List.length entries
    && List.exists (fun order -> List.for_all2 (fits at) entries order) (permutations bonds)
  in
  let ways x =
    let leaves = List.sort_uniq Int.compare (List.concat_map ends x) in
    List.fold_left
      (fun ways at ->
         let bonds = List.filter (fun b -> List.mem at (ends b)) x in
         Stdlib.( * ) ways
           (List.length (List.filter (matching at bonds) (rhos (State.leaf_of p at)))))
      1 leaves
  in
  powerset (Array.to_list p.bonds)
  |> List.filter (fun x -> x <> [] && connected x)
  |> List.concat_map (fun x ->
      let released = List.map (fun bond -> { Transition.bond; push = Scc_exact.Rat.zero }) x in
      List.init (ways x) (fun _ -> Transition.Strong_split released))

let strings m labels = List.sort String.compare (List.map (Transition.label_to_string m) labels)

let strong_is_brute_force name gen =
  QCheck2.Test.make ~name ~count:1500 gen (fun tree ->
      let m, s = setup tree in
      let p = s.processes.(0) in
      let mine = List.map (fun (o : Transition.outcome) -> o.label) (Splits.strong (standard m) p) in
      List.equal String.equal (strings m mine) (strings m (brute_force m p)))

let pieces_keep_everything ?(rings = false) name gen =
  QCheck2.Test.make ~name ~count:500 gen (fun tree ->
      let m, s = setup tree in
      let p = s.processes.(0) in
      let count f l = List.fold_left (fun n x -> Stdlib.( + ) n (f x)) 0 l in
      List.for_all
        (fun (o : Transition.outcome) ->
           let released =
             match o.label with
             | Strong_split x -> List.length x
             | Weak_split _ -> 1
             | _ -> 0
           in
           let leaves = count (fun (r : State.process) -> Array.length r.leaves) o.come in
           let bonds = count (fun (r : State.process) -> Array.length r.bonds) o.come in
           leaves = Array.length p.leaves
           && bonds = Stdlib.( - ) (Array.length p.bonds) released
           &&
           let most = Stdlib.( + ) released 1 in
           if rings then List.length o.come <= most else List.length o.come = most)
        (Splits.strong (standard m) p @ Splits.weak (standard m) p))

let pair ?splits b1 b2 =
  let bodies = [ body "p" (0, 0, 0) ~behaviour:b1; body "q" (2, 0, 0) ~behaviour:b2 ] in
  let m = model ?splits bodies in
  (m, start m (joined bodies [ ("a", (0, "right"), (1, "left")) ]))

let release = weak "a" [ "right"; "left" ]

let both_ends () =
  let m, s = pair (release nil) (release nil) in
  check_labels "both ends offer it" [ "weak(a, p.right, q.left)"; "time(1)" ] m s;
  let m, s = pair (release nil) nil in
  check_labels "one end alone cannot (I-6)" [] m s;
  let m, s = pair (release nil) (weak "b" [ "left" ] nil) in
  check_labels "the name is the bond's" [] m s;
  let m, s = pair (release nil) (weak "a" [ "top" ] nil) in
  check_labels "the bond's feature must be in the closure" [] m s

let instants () =
  let m, s = pair ~splits:(Every (ratio 1 4)) (release nil) (release nil + eps (ratio 3 8) nil) in
  check_labels "at once" [ "weak(a, p.right, q.left)"; "time(1/4)" ] m s;
  let s = take m s "time(1/4)" in
  check_labels "at the next multiple, and the eps is awaited" [ "weak(a, p.right, q.left)"; "time(1/8)" ] m s;
  let s = take m s "time(1/8)" in
  check_labels "an eps that brings up nothing leaves the clock alone (I-9)" [ "time(1/8)" ] m s;
  check_labels "which runs on" [ "weak(a, p.right, q.left)"; "time(1/4)" ] m (take m s "time(1/8)");
  let again = release nil + eps (ratio 3 8) (release (release nil)) in
  let m, s = pair ~splits:(Every (ratio 1 4)) (release nil) again in
  let s = take m (take m s "time(1/4)") "time(1/8)" in
  check_labels "so does one that offers the same bond once more" [ "time(1/8)" ] m s

(* The clock shows 1/2 when the pair of p and q runs into a wall. *)
let bounced () =
  let pair = [ body "p" (0, 0, 0) ~behaviour:(release nil); body "q" (2, 0, 0) ~behaviour:(release nil) ] in
  let bodies = pair @ [ body "w" (5, 0, 0) ~fixed:true ] in
  let whole = (joined ~velocity:(2, 0, 0) pair [ ("a", (0, "right"), (1, "left")) ]).processes.(0) in
  let wall = (declared bodies).processes.(2) in
  let m = model bodies in
  let s = start m (State.make ~processes:[ whole; wall ] ~step:None ~time:None) in
  let s = List.fold_left (take m) s [ "time(1/2)"; "bounce(p, w)" ] in
  check_labels "a bounce starts the clock anew" [ "weak(a, p.right, q.left)"; "time(1)" ] m s

(* p, q and r in a row: the bond of q and r can be released from 3/8 on. *)
let one_more () =
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(release nil);
      body "q" (2, 0, 0) ~behaviour:(release nil + weak "b" [ "right" ] nil);
      body "r" (4, 0, 0) ~behaviour:(eps (ratio 3 8) (weak "b" [ "left" ] nil));
    ]
  in
  let m = model ~splits:(Every (ratio 1 4)) bodies in
  let bonds = [ ("a", (0, "right"), (1, "left")); ("b", (1, "right"), (2, "left")) ] in
  let s = start m (joined bodies bonds) in
  let s = take m (take m s "time(1/4)") "time(1/8)" in
  check_labels "a further bond starts the clock of the process anew"
    [ "weak(a, p.right, q.left)"; "weak(b, q.right, r.left)"; "time(1/4)" ] m s

(* p and q are bound; q reacts to r, which arrives at 3; q's eps expires at 2. *)
let any_time () =
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(release nil);
      body "q" (2, 0, 0) ~behaviour:(release nil + eps (q 2) nil);
      body "r" (10, 0, 0) ~velocity:(-2, 0, 0);
    ]
  in
  let m = model ~splits:Any_time bodies in
  let bound = joined (List.filteri (fun i _ -> i < 2) bodies) [ ("a", (0, "right"), (1, "left")) ] in
  let apart = (declared bodies).processes.(2) in
  let s = start m (State.make ~processes:(apart :: Array.to_list bound.processes) ~step:None ~time:None) in
  let c = standard m in
  let split = "weak(a, p.right, q.left)" in
  check_labels "now, or later" [ split; "time(2)" ] m s;
  let wait d s =
    match Network.wait c s d with Ok (Some t) -> t.target | Ok None | Error _ -> Alcotest.fail "time may pass"
  in
  let refused what d s =
    match Network.wait c s d with Ok None -> () | Ok (Some _) | Error _ -> Alcotest.failf "%s: time passes" what
  in
  let later = wait (ratio 13 7) s in
  check_labels "at any instant" [ split; "time(1/7)" ] m later;
  Alcotest.(check bool) "the clock stands still" true
    (Array.exists (fun (p : State.process) -> p.clock = Some Rat.zero) later.processes);
  check_labels "and at those of other events" [ split; "time(1)" ] m (take m later "time(1/7)");
  refused "no time" Rat.zero s;
  refused "backwards" (q (-1)) s;
  refused "the greatest delay, which is a successor" (q 2) s;
  refused "past what happens next" (q 3) s;
  let met = take m (take m s "time(2)") "time(1)" in
  refused "while something collides" (ratio 1 2) met;
  let grid, on_grid = pair (release nil) (release nil) in
  (match Network.wait (standard grid) on_grid (ratio 1 2) with
   | Ok None -> ()
   | Ok (Some _) | Error _ -> Alcotest.fail "on a grid, time passes to the next instant");
  let m, s = pair ~splits:Any_time (release nil) (release nil) in
  let c = standard m in
  check_labels "nothing else is to come" [ split ] m s;
  Alcotest.(check bool) "it is not quiescent" false (Network.quiescent c s);
  match Network.wait c s (q 1000) with
  | Ok (Some t) -> check_labels "and time may pass by any time" [ split ] m t.target
  | Ok None | Error _ -> Alcotest.fail "time may pass"

let pieces_rest () =
  let m, s = pair (release nil) (release nil) in
  let s = take m s "weak(a, p.right, q.left)" in
  Alcotest.(check int) "two processes" 2 (Array.length s.processes);
  check_labels "they touch and nothing happens (I-11)" [] m s

let urgent () =
  let react = strong [ ("a", [ "right"; "left" ]) ] in
  let m, s = pair (react nil + eps (q 1) nil) (react nil) in
  check_labels "time does not pass while it is enabled" [ "strong({<a, {p.right, q.left}>})" ] m s;
  let m, s = pair (eps (q 1) (react nil)) (react nil) in
  check_labels "but it does before" [ "time(1)" ] m s

let separate_components () =
  let react faces = strong [ ("a", faces) ] nil in
  let bodies =
    [
      body "p" (0, 0, 0) ~behaviour:(react [ "right" ]); body "q" (2, 0, 0) ~behaviour:(react [ "left" ]);
      body "r" (4, 0, 0) ~behaviour:(react [ "right" ]); body "s" (6, 0, 0) ~behaviour:(react [ "left" ]);
    ]
  in
  let m = model bodies in
  let bonds =
    [ ("a", (0, "right"), (1, "left")); ("link", (1, "right"), (2, "left")); ("a", (2, "right"), (3, "left")) ]
  in
  check_labels "two reactions, not one (I-7)"
    [ "strong({<a, {p.right, q.left}>})"; "strong({<a, {r.right, s.left}>})" ]
    m
    (start m (joined bodies bonds))

(* {1 Pushes} *)

let velocities (t : Transition.t) =
  List.map (fun (p : State.process) -> Vec.to_string p.velocity) (Array.to_list t.target.processes)

(* Two that are bound and split at once; the faces that the bond has are its ends. *)
let parted ?(masses = (1, 2)) ?(fixed = false) ?(at = (2, 0, 0)) ~ends:(f, g) (one, two) =
  let entry face push = Behaviour.strong ~push [ channel "a" [ face ] ] nil in
  let bodies =
    [
      body "p" (0, 0, 0) ~fixed ~mass:(fst masses) ~velocity:(0, 3, 0) ~behaviour:(entry f one);
      body "q" at ~mass:(snd masses) ~velocity:(0, 3, 0) ~behaviour:(entry g two);
    ]
  in
  let m = model bodies in
  let s = declared bodies in
  let leaves = List.concat_map (fun (p : State.process) -> Array.to_list p.leaves) (Array.to_list s.processes) in
  let finish at face : State.finish = { at; site = { part = 0; feature = Fixture.face face } } in
  let bond = State.bond "a" (finish 0 f) (finish 1 g) in
  let velocity = if fixed then Vec.zero else Vec.of_ints 0 3 0 in
  let whole = State.process ~leaves ~bonds:[ bond ] ~velocity ~clock:None () in
  (m, State.make ~processes:[ whole ] ~step:None ~time:None)

let only_transition (m, s) =
  match Network.successors (standard m) s with
  | Ok [ t ] -> t
  | Ok _ | Error _ -> Alcotest.fail "one transition was expected"

let pushes () =
  let check what ?masses ?fixed ?at ends pushes label expected =
    let m, s = parted ?masses ?fixed ?at ~ends pushes in
    let t = only_transition (m, s) in
    Alcotest.(check string) what label (Transition.label_to_string m t.label);
    Alcotest.(check (list string)) what expected (velocities t)
  in
  let faces = ("right", "left") in
  check "face to face, by what both say" faces (ratio 1 2, q 1) "strong({<a, {p.right, q.left}> push(3/2)})"
    [ "(-3/2, 3, 0)"; "(3/4, 3, 0)" ];
  check "nothing is said" faces (q 0, q 0) "strong({<a, {p.right, q.left}>})" [ "(0, 3, 0)"; "(0, 3, 0)" ];
  check "off a wall" ~fixed:true faces (q 0, q 3) "strong({<a, {p.right, q.left}> push(3)})"
    [ "(0, 0, 0)"; "(3/2, 0, 0)" ];
  (* of two that touch with their edges, across, the normal is not one: from centre to centre, of length sqrt 8 *)
  let m, s = parted ~masses:(1, 1) ~at:(2, 2, 0) ~ends:faces (q 1, q 0) in
  let t = only_transition (m, s) in
  let v i = (t.target.processes.(i)).velocity in
  let relative = Vec.sub (v 1) (v 0) in
  Alcotest.(check bool) "along the diagonal" true
    (Rat.equal relative.x relative.y && Rat.sign relative.x > 0 && Rat.sign relative.z = 0);
  let half = Rat.div (Vec.norm2 relative) (q 4) in
  Alcotest.(check bool) "of length 1, or hardly less" true
    (Rat.compare half (q 1) < 0 && Rat.compare half (Rat.sub (q 1) (ratio 1 (1 lsl 38))) > 0)

(* Cubes of edge 2 and mass 1, side by side, shifted by 1 along y: the middle of their contact is 1/2 off both
   centres, and the moment of inertia 2/3. *)
let pushes_turn () =
  let m, s = parted ~masses:(1, 1) ~at:(2, 1, 0) ~ends:("right", "left") (q 1, q 0) in
  let rigid : Model.rigid = { dynamics = Constant_spin; resolution = ratio 1 1024; round_orientation = None } in
  let m = { m with rigid = Some rigid } in
  let p = s.State.processes.(0) in
  let due = State.with_turn ~spin:Vec.zero ~since:Rat.zero ~lasts:None p in
  let s = State.make ~processes:[ due ] ~step:None ~time:None in
  let t = only_transition (m, s) in
  Alcotest.(check (list string)) "velocities" [ "(-1, 3, 0)"; "(1, 3, 0)" ] (velocities t);
  Alcotest.(check (list string)) "spins" [ "(0, 0, 3/4)"; "(0, 0, 3/4)" ]
    (List.map (fun (p : State.process) -> Vec.to_string p.spin) (Array.to_list t.target.processes))

let suite =
  let case name f = Alcotest.test_case name `Quick f in
  ("split",
   [
     ( "cases",
       [
         case "WeakSplit: both ends must offer it (I-6)" both_ends;
         case "WeakSplit: only at split instants (I-9)" instants;
         case "I-9: a further bond" one_more; case "I-9: a bounce" bounced;
         case "WeakSplit: at any time (I-9)" any_time;
         case "WeakSplit: the pieces keep their motion (I-11)" pieces_rest;
         case "StrongSplit: urgent" urgent;
         case "I-36: pushes" pushes;
         case "I-36: of bodies that turn" pushes_turn;
         case "StrongSplit: separate components react separately (I-7)" separate_components;
       ] );
     ( "brute force",
       Scc_test_support.Property.cases
         [
           strong_is_brute_force "StrongSplit: the reactions are those of the definition" (gen_tree ());
           pieces_keep_everything "WeakSplit, StrongSplit: the pieces have all leaves and the other bonds"
             (gen_tree ());
           strong_is_brute_force "StrongSplit: so they are where bonds close rings (I-37)"
             (gen_tree ~rings:true ());
           pieces_keep_everything ~rings:true "WeakSplit, StrongSplit: what a ring holds stays one (I-37)"
             (gen_tree ~rings:true ());
         ] );
   ])
