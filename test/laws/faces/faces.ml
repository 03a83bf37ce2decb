open Scc_exact
open Scc_calculus
open Scc_polyhedra
open Scc_verify
open Scc_loading
open Scc_verdicts

type case = { text : string; any : bool; bounds : Setup.t }

(* {1 Models} *)

let int random n = Random.State.int random n
let one random list = List.nth list (int random (List.length list))
let chance random p = Random.State.float random 1. < p
let some random n f = List.init (1 + int random n) (fun _ -> f ())
let print = Printf.sprintf
let names = [ "u"; "v"; "w" ]

let range random name =
  let low, high = one random [ (0, 1); (0, 1); (0, 2); (1, 2); (-1, 1); (1, 3) ] in
  let left = one random [ "["; "["; "[" ; "(" ] and right = one random [ "]"; "]"; "]"; ")" ] in
  (name, low, high, print "param %s in %s%d, %d%s" name left low high right)

(* Forms, most of which are 0 somewhere on a face. *)
let form random ranges =
  let name, low, high, _ = one random ranges and other, low', high', _ = one random ranges in
  one random
    [ "0"; "1/2"; "1"; "2"; name; print "%s - %d" name low; print "%d - %s" high name;
      print "%s + %s - %d" name other (low + low'); print "%s - %s + %d" name other (high' - low);
      print "(%s + %s - %d)/2" name other (low + low'); print "%d - %s - %s" (high + high') name other;
      print "2*%s - %d" name (2 * low) ]

let faces = [ "left"; "right"; "left, right"; "top, right" ]

(* Names that come later; and any, behind a prefix or a delay that guards them. *)
let rec term random ~form ~later ~all depth =
  let next ~later = term random ~form ~later ~all (depth - 1) in
  let guarded () = next ~later:all and free () = next ~later in
  if depth = 0 then one random ("nil" :: later)
  else
    match int random 14 with
    | 0 -> "nil"
    | 1 -> one random ("nil" :: later)
    | 2 | 3 | 4 when later <> [] -> print "eps(%s). %s" (form ()) (one random later)
    | 2 | 3 | 4 | 5 | 6 -> print "eps(%s). %s" (form ()) (free ())
    | 7 -> print "eps(%s). %s" (one random [ "1"; "1/2"; "2" ]) (guarded ())
    | 8 | 9 -> print "<%s, {%s}>. %s" (one random [ "a"; "~a"; "b"; "~b" ]) (one random faces) (guarded ())
    | 10 | 11 -> print "omega(%s, {%s}). %s" (one random [ "a"; "b" ]) (one random faces) (guarded ())
    | 12 -> print "rho({<%s, {%s}>}). %s" (one random [ "a"; "b" ]) (one random faces) (guarded ())
    | _ -> print "(%s + %s)" (free ()) (free ())

let atom random ~form ~bodies ~behaviours ~channels =
  let p = one random bodies and q = one random bodies in
  let compared () = one random [ "<"; "<="; "="; ">="; ">" ] in
  match int random 12 with
  | 0 | 1 | 2 -> print "behaviour(%s) = %s" p (one random behaviours)
  | 3 -> if p = q then print "size(%s) = 1" p else print "bound(%s, %s)" p q
  | 4 -> if p = q then "processes = 2" else print "touching(%s, %s)" p q
  | 5 | 6 -> print "x(%s) %s %s" p (compared ()) (form ())
  | 7 | 8 -> print "time %s %s" (compared ()) (form ())
  | 9 when channels <> [] -> print "offers(%s, %s)" p (one random channels)
  | 10 -> print "event %s" (one random [ "bind"; "bounce"; "bounce(" ^ p ^ ")" ])
  | _ -> print "vx(%s) %s 0" p (compared ())

let rec proposition random ~atom depth =
  let again () = proposition random ~atom (depth - 1) in
  if depth = 0 then atom ()
  else
    match int random 6 with
    | 0 -> print "(not %s)" (atom ())
    | 1 -> print "(%s and %s)" (again ()) (again ())
    | 2 -> print "(%s or %s)" (again ()) (again ())
    | _ -> atom ()

(* Bounds of an exploration, most of which end it before all is known. *)
let bounds ?(time = Bounds.Unbounded) states depth =
  { Setup.default with bounds = { Bounds.default with states = Given states; depth = Given depth; time } }

let some_bounds random =
  if chance random 0.5 then bounds 150 60
  else
    bounds
      ~time:(one random Bounds.[ Unbounded; Unbounded; Given Rat.one; Given (Rat.of_int 2); Given (Rat.of_int 4) ])
      (one random [ 2; 4; 6; 10; 17; 30; 70 ])
      (one random [ 2; 4; 7; 12; 60 ])

let rec formula random ~any ~atom depth =
  let inner () =
    if depth > 0 && chance random 0.35 then formula random ~any ~atom (depth - 1)
    else "(" ^ proposition random ~atom 1 ^ ")"
  in
  let bound =
    if depth < 1 || chance random 0.5 then ""
    else
      let low = one random [ "0"; "1/2"; "1"; "1"; "2"; "3" ] in
      let more = one random [ ""; " + 1"; " + 2"; " + 1/2" ] in
      print "[%s, %s%s]" low low more
  in
  let quantifier = one random (if any then [ "A"; "E"; "E" ] else [ "A"; "E" ]) in
  match int random 7 with
  | 5 | 6 -> print "%sX %s" quantifier (inner ())
  | 0 | 1 -> print "%sF%s %s" quantifier bound (inner ())
  | 2 | 3 -> print "%sG%s %s" quantifier bound (inner ())
  | _ -> print "%s[%s U%s %s]" quantifier (inner ()) bound (inner ())

(* Two bodies that are bound, or bodies that stand in a row, far enough from each other as a rule. *)
let bodies random ~form ~behaviours =
  let bound = chance random 0.3 in
  let place i =
    let x = if chance random 0.7 then form () else "0" in
    print "%d + %s" (3 * i) x
  in
  let y () = one random [ "0"; "0"; "0"; "0"; "1"; "1/2"; form () ] in
  let velocity () = print "(%d,%d,0)" (int random 5 - 2) (one random [ 0; 0; 0; 1 ]) in
  let process name velocity place y =
    print "process %s = Cube mass %d velocity %s at translate (%s, %s, 0) [%s]" name (1 + int random 2) velocity
      place y (one random behaviours)
  in
  let free i name =
    if i > 0 && chance random 0.2 then
      if chance random 0.3 then print "fixed %s = Cube absorb at translate (%s, %s, 0)" name (place i) (y ())
      else print "fixed %s = Cube at translate (%s, %s, 0) [%s]" name (place i) (y ()) (one random behaviours)
    else process name (velocity ()) (place i) (y ())
  in
  let names = List.filteri (fun i _ -> i < (if bound then 2 else 1) || chance random 0.6) [ "p"; "q"; "r" ] in
  if not bound then (names, List.mapi free names)
  else
    let v = velocity () and x = place 0 and y = y () in
    let one = process "p" v x y and two = process "q" v (x ^ " + 1") y in
    let bond = print "bond <%s, {p.right, q.left}>" (if chance random 0.7 then "a" else "b") in
    (names, [ one; two; bond ] @ List.mapi (fun i name -> free (i + 2) name) (List.tl (List.tl names)))

let generate random =
  let any = chance random 0.2 in
  let ranges = List.map (range random) (List.filteri (fun i _ -> i = 0 || chance random 0.6) names) in
  let form () = form random ranges in
  let behaviours = List.init (2 + int random 3) (print "K%d") in
  let behaviour i name =
    let later = List.filteri (fun j _ -> j > i) behaviours in
    print "behaviour %s on Cube = %s" name (term random ~form ~later ~all:behaviours (1 + int random 3))
  in
  let behaviour_lines = List.mapi behaviour behaviours in
  let bodies, body_lines = bodies random ~form ~behaviours in
  let declared = String.concat " " (behaviour_lines @ body_lines) in
  let has channel =
    let parts = String.split_on_char ',' declared in
    List.exists (fun part -> String.length part >= 2 && String.ends_with ~suffix:channel part) parts
  in
  let channels = List.filter (fun c -> has ("<" ^ c) || has ("(" ^ c)) [ "a"; "b" ] in
  let atom () = atom random ~form ~bodies ~behaviours ~channels in
  let checks =
    some random 4 (fun () -> formula random ~any ~atom (1 + int random 2))
    |> List.mapi (fun i f -> print "check c%d : %s" i f)
  in
  let lines =
    [ (if any then "split_step any" else one random [ "split_step 1"; "split_step 1/2" ]);
      one random [ ""; ""; "collisions together" ]; "shape Cube = box(1,1,1)" ]
    @ List.map (fun (_, _, _, line) -> line) ranges
    @ behaviour_lines @ body_lines @ checks
  in
  { text = String.concat "\n" lines ^ "\n"; any; bounds = some_bounds random }

(* {1 Comparison} *)

type counts = {
  mutable refused : int;
  mutable models : int;
  mutable points : int;
  mutable faces : int;
  mutable unknown : int;
  mutable partial : int;  (** of branching formulas, where not all was explored *)
}

let counts () = { refused = 0; models = 0; points = 0; faces = 0; unknown = 0; partial = 0 }
let at_points = bounds 600 120

let load text =
  let source = Scc_base.Source.make ~name:"faces.sc" text in
  Loaded.load ~read_file:(fun _ -> Error "no files") ~overrides:[] source

let report options (l : Loaded.t) ~exactly =
  Result.bind (Loaded.initial l) (fun initial -> Verdicts.report options l ~initial ~exactly ~premises:[] l.checks)

let known (o : Verdict.outcome) =
  match o.verdict with Holds { bounds = []; _ } -> Some true | Violated _ -> Some false | _ -> None

let point_text (l : Loaded.t) point =
  let value i q = print "%s=%s" l.model.ranges.(i).name (Rat.to_string q) in
  String.concat " " (Array.to_list (Array.mapi value point))

let named (l : Loaded.t) point = Array.to_list (Array.mapi (fun i q -> (l.model.ranges.(i).Ranges.name, q)) point)

(* Points of all pieces, of their borders and of all faces of the ranges; and some whose coordinates coincide. *)
let points random (l : Loaded.t) (where : Scc_regions.Where.t list) =
  let of_piece p =
    List.filter_map (fun f -> f p)
      [ Polyhedron.corner; Polyhedron.interior_point; (fun p -> Polyhedron.corner (Polyhedron.closure p)) ]
  in
  let known (w : Scc_regions.Where.t) = Union.pieces w.holds @ Union.pieces w.fails in
  let pieces = List.concat_map known where in
  let on_face _ =
    let coordinate (r : Ranges.range) =
      let quarter = Rat.div (Rat.sub r.high.value r.low.value) (Rat.of_int 4) in
      let between k = Rat.add r.low.value (Rat.mul (Rat.of_int k) quarter) in
      between (one random [ 0; 0; 1; 2; 3; 4; 4 ])
    in
    Array.map coordinate l.model.ranges
  in
  let all = List.concat_map of_piece pieces @ List.init 6 on_face in
  let same p = Array.map (fun _ -> p.(0)) p in
  let all = all @ List.map same (List.filteri (fun i _ -> i < 3) all) in
  let inside = List.filter (Polyhedron.mem (Ranges.box l.model.ranges)) all in
  let distinct = List.sort_uniq (fun p q -> List.compare Rat.compare (Array.to_list p) (Array.to_list q)) inside in
  let chosen = List.filter (fun _ -> chance random (12. /. float_of_int (List.length distinct))) distinct in
  chosen

let on_end (l : Loaded.t) point =
  let is_end i q =
    let r = l.model.ranges.(i) in
    Rat.equal q r.low.value || Rat.equal q r.high.value
  in
  List.exists Fun.id (Array.to_list (Array.mapi is_end point))

let compare_at counts case (l : Loaded.t) (report_of_sets : Check.report) point =
  let fixed values =
    match Loaded.at l values with
    | Error faults -> Error faults
    | Ok l when case.any ->
      let model = { l.model with splits = Every (Rat.make Z.one (Z.of_int 2)) } in
      Ok { l with model; semantics = Scc_semantics.Semantics.with_model l.semantics model }
    | Ok l -> Ok l
  in
  let one (o : Verdict.outcome) (w : Scc_regions.Where.t) =
    let mem u = Union.mem u point in
    let of_sets = if mem w.holds then Some true else if mem w.fails then Some false else None in
    match (known o, of_sets) with
    | Some false, Some _ when case.any -> None
    | Some true, Some _ when case.any && String.contains o.check.text 'A' -> None
    | Some a, Some b ->
      counts.points <- counts.points + 1;
      let is_search = Scc_property.Plan.(is_search (of_formula o.check.formula)) in
      if not (is_search || report_of_sets.stats.complete) then counts.partial <- counts.partial + 1;
      if on_end l point then counts.faces <- counts.faces + 1;
      if a = b then None
      else
        Some (print "%s at %s: %b at the point, %b over sets" o.check.name (point_text l point) a b)
    | _ ->
      counts.unknown <- counts.unknown + 1;
      None
  in
  match Result.bind (fixed (named l point)) (report at_points ~exactly:false) with
  | Error (d :: _) -> [ print "refused at %s: %s" (point_text l point) d.Scc_base.Diag.message ]
  | Error [] -> [ "refused without a reason" ]
  | Ok at_point -> List.filter_map Fun.id (List.map2 one at_point.outcomes report_of_sets.where)

(* A model of the face on which one parameter has a value, with ranges for the others. *)
let compare_face counts random bounds (l : Loaded.t) (whole : Check.report) point =
  let k = int random (Array.length point) in
  let name = l.model.ranges.(k).name in
  if Array.length point < 2 then []
  else
    match Result.bind (Loaded.at l [ (name, point.(k)) ]) (report bounds ~exactly:true) with
    | Error (d :: _) -> [ print "refused on %s=%s: %s" name (Rat.to_string point.(k)) d.message ]
    | Error [] -> [ "refused without a reason" ]
    | Ok face ->
      let rest = Array.of_list (List.filteri (fun i _ -> i <> k) (Array.to_list point)) in
      let value (w : Scc_regions.Where.t) point =
        if Union.mem w.holds point then Some true else if Union.mem w.fails point then Some false else None
      in
      let one (o : Verdict.outcome) (w, f) =
        match (value w point, value f rest) with
        | Some a, Some b ->
          counts.faces <- counts.faces + 1;
          if a = b then None
          else
            Some
              (print "%s at %s: %b over sets, %b over those with %s=%s" o.check.name (point_text l point) a b name
                 (Rat.to_string point.(k)))
        | _ -> None
      in
      List.filter_map Fun.id (List.map2 one whole.outcomes (List.combine whole.where face.where))

let differences counts random case =
  match load case.text with
  | Error _ ->
    counts.refused <- counts.refused + 1;
    []
  | Ok l -> (
      match report case.bounds l ~exactly:true with
      | exception Scc_base.Bug.Bug ((file, line, _, _), why) -> [ print "Bug at %s:%d: %s" file line why ]
      | Error _ ->
        counts.refused <- counts.refused + 1;
        []
      | Ok sets -> (
          counts.models <- counts.models + 1;
          let points = points random l sets.where in
          let face =
            match points with
            | p :: _ when not case.any -> compare_face counts random case.bounds l sets p
            | _ -> []
          in
          match List.concat_map (compare_at counts case l sets) points with
          | exception Scc_base.Bug.Bug ((file, line, _, _), why) ->
            [ print "Bug at %s:%d: %s, at a point" file line why ]
          | found -> face @ found))
