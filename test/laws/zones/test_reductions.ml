(* The reductions leave verdicts over zones, and sets of values, as they are: on and off, on all models of
   specs/models, at any time as well, and on random scenes of parts that may or may not meet. What is shown is
   replayed by whoever makes it, as a run of the whole. *)

open Scc_polyhedra
open Scc_verify
open Scc_state_space
open Scc_zones
module Loaded = Scc_loading.Loaded
module Where = Scc_regions.Where

let models = "../../../specs/models"

let read path =
  let channel = open_in_bin path in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let load name text =
  let read_file name = try Ok (read (Filename.concat models name)) with Sys_error e -> Error e in
  Loaded.load ~read_file ~overrides:[] (Scc_base.Source.make ~name text)

(* So many zones are expanded in all. With a bound on them invariants would be looked for. *)
let options ~states reductions =
  let left = ref states in
  let stop () =
    decr left;
    if !left < 0 then Some Scc_graph_search.Limits.Interrupted else None
  in
  { Setup.default with surroundings = Scc_graph_search.Limits.undivided ~stop (); reductions }

let run ~states reductions (l : Loaded.t) =
  let u = match l.uncertain with Some u -> u | None -> Scc_symbolic.Start.known l.model l.declared in
  let { Loaded.semantics; declared; checks; _ } = l in
  Zone_check.run (options ~states reductions) semantics u ~declared ~exactly:true ~premises:[] checks

let compared = ref 0 and complete = ref 0 and sliced = ref 0 and lesser = ref 0 and renamed = ref 0

let kind : Verdict.t -> string option = function
  | Holds { bounds = []; _ } -> Some "holds"
  | Violated _ -> Some "violated"
  | Holds _ | Measured _ | Depends _ | Undecided _ -> None

(* What one leaves open contradicts nothing; but where both know all, they know the same. *)
let same name ((a, v) : Verdict.outcome * Where.t) ((b, w) : Verdict.outcome * Where.t) =
  let name = name ^ ": " ^ a.check.Scc_property.Property.name in
  let must what right = if not right then Alcotest.failf "%s, %s" name what in
  let none u = must "sets" (Union.is_empty u) in
  none (Union.inter v.holds w.fails);
  none (Union.inter v.fails w.holds);
  match (kind a.verdict, kind b.verdict) with
  | Some one, Some two ->
    incr compared;
    must (one ^ " with reductions") (String.equal one two);
    if Union.is_empty v.unknown && Union.is_empty w.unknown then begin
      incr complete;
      must "not the same set" (Union.equal v.holds w.holds)
    end
  | None, _ | _, None -> ()

let compared_with ~states name l off kinds =
  match run ~states kinds l with
  | Error _ -> Alcotest.fail "it is not well-formed with reductions"
  | Ok (on : Check.report) ->
    sliced := !sliced + List.length on.slices;
    let shorter = on.stats.states < off.Check.stats.states in
    if kinds = [ Reduction.Order ] && shorter then incr lesser;
    if kinds = [ Reduction.Symmetry ] && shorter then incr renamed;
    List.iter2 (same name) (List.combine on.outcomes on.where) (List.combine off.outcomes off.where)

let agree ~states name l =
  match run ~states [] l with
  | Error _ -> ()
  | Ok off -> List.iter (compared_with ~states name l off)
                [ Reduction.all; [ Order ]; [ Translation ]; [ Symmetry ] ]

let loaded name text =
  match load name text with
  | Error _ -> None
  | Ok l -> if Zone_check.refused l.model Zones = [] then Some l else None

let at_any_time text = Str.global_replace (Str.regexp "^split_step .*$") "split_step any" text

let of_model file () =
  let text = read (Filename.concat models file) in
  let texts = List.sort_uniq String.compare [ text; at_any_time text ] in
  List.iter (fun text -> Option.iter (agree ~states:200 file) (loaded file text)) texts

(* {1 Random scenes} *)

let head =
  {|model scene
split_step any
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
param s in [0, 2]
param t in [-1, 3]
behaviour Left  on Cube = eps(1). omega(link, {right}). nil + eps(4). rho({<link, {right}>}). nil
behaviour Right on Cube = eps(1). omega(link, {left}). nil + eps(4). rho({<link, {left}>}). nil
behaviour Soon  on Cube = eps(s). rho({<link, {right}>}). nil
behaviour Port  on Cube = <~a, {left, right, front, back}>. nil
behaviour Seek  on Cube = <a, {left, right, front, back}>. omega(a, {left, right, front, back}). nil
|}

let pick = Crowds.pick

(* Whether much comes at once. *)
let busy = ref false

let about () =
  if !busy then pick [ "0"; "0"; "0"; "s" ] else pick [ "0"; "0"; "1"; "-1"; "s"; "t"; "s + t"; "1 - s"; "2 * t" ]
let speed () = pick [ "0"; "0"; "0"; "1"; "-1"; "1/2"; "-2" ]

(* Bodies with their checks: along x, in a row at y. *)
let part i y =
  let at x y = Printf.sprintf "translate (%s, %d + %s, 0)" x y (about ()) in
  let p = Printf.sprintf "p%d" i and q = Printf.sprintf "q%d" i in
  match Random.int 5 with
  | 0 ->
    let x = Random.int 5 and v = Printf.sprintf "velocity (%s, %s, 0)" (speed ()) (speed ()) in
    let left = pick [ "Left"; "Soon" ] in
    let right = if left = "Left" then "Right" else "nil" in
    let offset = about () in
    let cube name x b =
      Printf.sprintf "process %s = Cube mass 1 %s at translate (%d + %s, %d, 0) [%s]\n" name v x offset y b
    in
    let right = if right = "nil" then "eps(s). rho({<link, {left}>}). nil" else right in
    ( cube p x left ^ cube q (x + 2) right ^ Printf.sprintf "bond <link, {%s.right, %s.left}>\n" p q,
      [ Printf.sprintf "not bound(%s, %s)" p q; Printf.sprintf "x(%s) > %d" q (x + 4);
        Printf.sprintf "vy(%s) > 1/4 or event split(link)" p ] )
  | 1 ->
    ( Printf.sprintf "process %s = Cube mass %d velocity (1, 0, 0) at %s [Seek]\n" p (1 + Random.int 2) (at "-4" y)
      ^ Printf.sprintf "process %s = Cube mass 1 velocity (-1/2, 0, 0) at %s [Port]\n" q (at "2" y),
      [ Printf.sprintf "bound(%s, %s)" p q; Printf.sprintf "vx(%s) > 0" q;
        Printf.sprintf "event bind(a, %s, %s)" p q ] )
  | 2 ->
    ( Printf.sprintf "process %s = Cube mass 1 velocity (1, %s, 0) at %s [nil]\n" p (speed ()) (at "-3" y)
      ^ Printf.sprintf "fixed %s = Cube at %s [nil]\n" q (at "4" y),
      [ Printf.sprintf "vx(%s) < 0" p; Printf.sprintf "x(%s) > 2" p;
        Printf.sprintf "touching(%s, %s)" p q ] )
  | 3 ->
    ( Printf.sprintf "process %s = Cube mass 2 velocity (%s, %s, 0) at %s [nil]\n" p (speed ()) (speed ())
        (at "3" y),
      [ Printf.sprintf "y(%s) > %d" p (y + 3); Printf.sprintf "vy(%s) < 0" p ] )
  | _ ->
    ( Printf.sprintf "process %s = Cube mass 1 velocity (%s, %s, 0) at %s [Seek]\n" p (speed ()) (speed ())
        (at "0" y)
      ^ Printf.sprintf "fixed %s = Cube at %s [Port]\n" q (at "5" y),
      [ Printf.sprintf "bound(%s, %s)" p q; Printf.sprintf "vx(%s) < 0" p ] )

let scene () =
  busy := Random.bool ();
  let apart = pick (if !busy then [ 2; 3; 7 ] else [ 7; 9; 12; 25 ]) in
  let parts = List.init (1 + Random.int 3) (fun i -> part i (i * apart)) in
  let one = pick parts in
  let atom () = pick (snd (if !busy then one else pick parts)) in
  let prop () = if Random.int 3 = 0 then Printf.sprintf "(%s) and (%s)" (atom ()) (atom ()) else atom () in
  let check i =
    let within = if Random.int 4 > 0 then Printf.sprintf " within %d" (1 + Random.int 5) else "" in
    let kind = pick [ "possibly"; "always"; "possibly not"; "always not" ] in
    Printf.sprintf "check c%d : %s (%s)%s\n" i kind (prop ()) within
  in
  head ^ String.concat "" (List.map fst parts) ^ String.concat "" (List.init 3 check)

let scenes = 150
let used = ref 0

let random () =
  Random.init 15;
  for i = 1 to scenes do
    let text = scene () in
    match loaded (Printf.sprintf "scene %d\n%s" i text) text with
    | None -> ()
    | Some l ->
      incr used;
      agree ~states:120 (Printf.sprintf "scene %d\n%s" i text) l
  done

(* {1 Interchangeable leaves} *)

(* At least, and until enough explorations are shorter. *)
let crowds = 90
let shorter = 6
let crowded = ref 0

let interchangeable () =
  Random.init 16;
  let rec from i =
    let text = Crowds.text () in
    let name = Printf.sprintf "crowd %d\n%s" i text in
    let compare l =
      incr crowded;
      agree ~states:120 name l
    in
    Option.iter compare (loaded name text);
    if i < crowds || (!renamed <= shorter && i < 5 * crowds) then from (i + 1)
  in
  from 1;
  Printf.printf "%d crowds, %d explorations made shorter\n" !crowded !renamed;
  Alcotest.(check bool) "crowds" true (!crowded > crowds / 2 && !renamed > shorter)

(* Two that go round opposite to each other, and are each where the other one was after half a round. *)
let carousel () =
  let text = read (Filename.concat models "carousel.sc") in
  let change (old, fresh) text = Str.global_replace (Str.regexp_string old) fresh text in
  let text =
    List.fold_right change
      [
        ("fixed west", "param d in [-1/2, 1/2]\nfixed west"); ("(-1,-4,0)", "(-1 + d, -4 + d, 0)");
        ("(1,4,0)", "(1 - d, 4 - d, 0)"); ("x(b) = 5)", "x(b) >= 5)");
      ]
      text
  in
  let states kinds =
    match Option.map (run ~states:200 kinds) (loaded "carousel" text) with
    | Some (Ok report) -> report.stats.states
    | Some (Error _) | None -> Alcotest.fail "it is refused"
  in
  Alcotest.(check (list int)) "zones" [ 17; 9 ] [ states []; states [ Reduction.Symmetry ] ]

(* {1 What is left out}

   Each with the leaves that no slice has, by hand. *)

let left_out what expected text =
  match loaded what (head ^ text) with
  | None -> Alcotest.failf "%s is refused" what
  | Some l -> (
      match run ~states:300 Reduction.all l with
      | Error _ -> Alcotest.failf "%s is not well-formed" what
      | Ok report ->
        let names = List.concat_map (fun (s : Check.slice) -> s.left_out) report.slices in
        Alcotest.(check (list string)) what expected names)

let slices () =
  let far = "process u = Cube mass 1 at translate (0, 1000000, 0) [nil]\n" in
  let between speed =
    Printf.sprintf
      {|fixed v = Cube at translate (6, 0, 0) [nil]
fixed w = Cube at translate (-3, 0, 0) [nil]
process a = Cube mass 1 velocity (%d, 0, 0) at translate (s, 0, 0) [nil]
check c : always x(u) = 0 within 4
|}
      speed
  in
  left_out "it bounces to and fro" [ "v"; "w"; "a" ] (far ^ between 1);
  left_out "too often to be known" [] (far ^ between 3000);
  (* v is at 5 + t, between 4 and 8, and so its side between 3 and 7; p gets from 1 to 5 in time 4, for s = 0, and
     to 7 for s = 2. It may meet v, but where both are at the same height. *)
  let meets y =
    Printf.sprintf
      {|process p = Cube mass 1 velocity (1, 0, 0) at translate (s, 0, 0) [nil]
process v = Cube mass 1 at translate (5 + t, %s, 0) [nil]
check c : always vx(p) = 1 within 4
|}
      y
  in
  left_out "it may be met" [] (meets "0");
  left_out "it is passed by, at most along a side" [ "v" ] (meets "s + 2");
  left_out "it is met for few values" [] (meets "s + 1");
  (* In time, v with s = 2 is first met when t = -1: its side is at 3, and that of p at 3 for s = 2. *)
  let within horizon speed =
    Printf.sprintf
      {|process p = Cube mass 1 velocity (%s, 0, 0) at translate (-s, 0, 0) [nil]
process v = Cube mass 1 at translate (5 + t, 0, 0) [nil]
check c : always vx(p) = %s within %s
|}
      speed speed horizon
  in
  left_out "it is met just in time" [] (within "2" "1");
  left_out "it is met just too late" [ "v" ] (within "19/10" "1");
  (* What was hit may be as fast as all of the energy makes it, wherever it goes: 2E = 4 and mass 1 make it 2. *)
  let through y =
    Printf.sprintf
      {|process p = Cube mass 1 velocity (2, 0, 0) at translate (-3 - s, 0, 0) [nil]
process v = Cube mass 1 at translate (0, 0, 0) [nil]
process b = Cube mass 1 at translate (0, %s, 0) [nil]
check c : always vy(b) = 0 within 2
|}
      y
  in
  left_out "what may be hit aside" [] (through "6");
  left_out "what may not" [ "p"; "v" ] (through "6.5");
  left_out "a place that only some values give" [] (through "7 + t")

(* {1 Where the whole is} *)

(* Two that tick, each at its time, and fly on side by side for ever: finitely many zones, where nobody asks where
   they are. *)
let drift =
  {|behaviour Tick on Cube = eps(1). Tock
behaviour Tock on Cube = eps(2). Tick
process p = Cube mass 1 velocity (1, 0, 0) at translate (s, 0, 0) [Tick]
process q = Cube mass 1 velocity (1, 0, 0) at translate (10 + t, 0, 0) [Tock]
|}

let displaced () =
  let is what expected kinds check =
    match loaded what (head ^ drift ^ check) with
    | None -> Alcotest.failf "%s is refused" what
    | Some l -> (
        match run ~states:50 kinds l with
        | Error _ -> Alcotest.failf "%s is not well-formed" what
        | Ok report -> Alcotest.(check bool) what expected report.stats.complete)
  in
  let near = "check a : always not touching(p, q)" in
  is "it comes back" true Reduction.all near;
  is "it does not, where all is told apart" false [] near;
  is "nor where somebody asks" false Reduction.all "check a : always x(p) > -1 and not touching(p, q)";
  is "nor with a fixed body" false Reduction.all
    ("fixed w = Cube at translate (0, 10, 0) [nil]\ncheck a : always not touching(p, q) and not touching(p, w)")

(* {1 Independent events of one instant} *)

(* Some that have to split at 1, all at once, and one that is looked at: without slices, which would leave out the
   others. *)
let order () =
  let dimer i =
    Printf.sprintf
      {|process p%d = Cube mass 1 at translate (s, %d, 0) [eps(1). rho({<link, {right}>}). nil]
process q%d = Cube mass 1 at translate (2 + s, %d, 0) [eps(1). rho({<link, {left}>}). nil]
bond <link, {p%d.right, q%d.left}>
|}
      i (10 * i) i (10 * i) i i
  in
  let states kinds text =
    match Option.map (run ~states:200 kinds) (loaded "dimers" (head ^ text)) with
    | Some (Ok report) -> report.stats.states
    | Some (Error _) | None -> Alcotest.fail "it is refused"
  in
  let three = dimer 0 ^ dimer 1 ^ dimer 2 in
  let is what expected kinds text = Alcotest.(check int) what expected (states kinds text) in
  (* the start, and at 1 each of them in one piece or two *)
  is "all orders" 9 [] (three ^ "check a : always vx(p0) = 0");
  (* at 1 nobody, the first of the others, both of them, all *)
  is "one order of the others" 5 [ Order ] (three ^ "check a : always vx(p0) = 0");
  is "somebody looks at them" 9 [ Order ] (three ^ "check a : always vx(p0) + vx(p1) + vx(p2) = 0");
  is "no search" 9 [ Order ] (three ^ "check a : AG EF vx(p0) = 0")

(* Who binds first at one instant decides, and either may (I-8). a and v come to b at once, one of which is looked
   at; a and c come to b at once, none of which is. If a binds, both go on at 1/2 and v gets 2/3 from them; else c
   does, and off these two, of mass 2, a bounces: they go on at 2/3, and v gets 8/9. *)
let ties () =
  let holds what text =
    let l = match loaded what (head ^ text) with Some l -> l | None -> Alcotest.failf "%s is refused" what in
    let with_ kinds =
      match run ~states:200 kinds l with
      | Error _ -> Alcotest.failf "%s is not well-formed" what
      | Ok report ->
        let is (o : Verdict.outcome) = Alcotest.(check (option string)) what (Some "holds") (kind o.verdict) in
        List.iter is report.outcomes
    in
    List.iter with_ [ []; [ Reduction.Order ]; Reduction.all ]
  in
  holds "one of both is looked at"
    {|process a = Cube mass 1 velocity (1, 0, 0) at translate (-3 + s, 0, 0) [Seek]
process b = Cube mass 1 at translate (s, 0, 0) [Port]
process v = Cube mass 1 velocity (-1, 0, 0) at translate (3 + s, 0, 0) [Seek]
check first : possibly bound(v, b)
check second : possibly vx(v) > 0
|};
  holds "neither is"
    {|process a = Cube mass 1 velocity (1, 0, 0) at translate (-3 + s, 0, 0) [Seek]
process b = Cube mass 1 at translate (s, 0, 0) [Port]
process c = Cube mass 1 velocity (0, 1, 0) at translate (s, -3, 0) [Seek]
process v = Cube mass 1 at translate (3 + s, 0, 0) [nil]
check one : possibly vx(v) = 2/3
check other : possibly vx(v) = 8/9
|}

let enough () =
  Printf.printf "%d scenes, %d verdicts, of %d all is known, %d slices, %d explorations made shorter\n" !used
    !compared !complete !sliced !lesser;
  Alcotest.(check bool) "many verdicts" true (!compared > 300);
  Alcotest.(check bool) "many slices" true (!sliced > 50);
  Alcotest.(check bool) "much that was left out" true (!lesser > 4)

let () =
  let files = List.filter (fun f -> Filename.check_suffix f ".sc") (Array.to_list (Sys.readdir models)) in
  let case file = Alcotest.test_case file `Quick (of_model file) in
  Alcotest.run "reductions over zones"
    [
      ("models", List.map case (List.sort String.compare files));
      ("slices", [ Alcotest.test_case "what is left out" `Quick slices ]);
      ("translation", [ Alcotest.test_case "where the whole is" `Quick displaced ]);
      ( "order",
        [ Alcotest.test_case "one order" `Quick order; Alcotest.test_case "who comes first" `Quick ties ] );
      ( "symmetry",
        [
          Alcotest.test_case "half a round" `Quick carousel;
          Alcotest.test_case "random" `Quick interchangeable;
        ] );
      ("scenes", [ Alcotest.test_case "random" `Quick random ]);
      ("enough", [ Alcotest.test_case "compared" `Quick enough ]);
    ]
