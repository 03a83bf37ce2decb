(* Planes of parameters: their regions, the outlines of these, what can be shown, the marks of axes. *)
open Scc_exact
open Scc_polyhedra
open Scc_calculus
open Scc_regions
open Where_samples.Samples
module G = QCheck2.Gen

let view ranges axes fixed =
  match Plane.view ranges ~axes ~fixed with
  | Ok view -> view
  | Error message -> Alcotest.fail message

(* {1 What can be shown} *)

let three = [| whole "x" 0 4; whole "y" 0 4; range ~low:false "z" (q 0 1) (q 1 1) |]

let views () =
  let check name expected axes fixed =
    let found =
      match Plane.view three ~axes ~fixed with
      | Error message -> message
      | Ok v ->
        let name = Ranges.name three in
        String.concat " "
          (name v.across
           :: (match v.up with Some i -> name i | None -> "-")
           :: List.map (fun (i, x) -> name i ^ "=" ^ Rat.to_string x) v.fixed
           @ List.map (fun i -> "any " ^ name i) (Plane.hidden three v))
    in
    Alcotest.(check string) name expected found
  in
  check "the first two" "x y any z" [] [];
  check "named" "z x any y" [ "z"; "x" ] [];
  check "one" "y - any x any z" [ "y" ] [];
  check "what is not fixed" "y z x=1" [] [ ("x", Rat.one) ];
  check "one is left" "y - x=1 z=1/2" [] [ ("x", Rat.one); ("z", q 1 2) ];
  check "not there" "there is no parameter 'w' that has a range" [ "w" ] [];
  check "fixed and not there" "there is no parameter 'w' that has a range" [] [ ("w", Rat.one) ];
  check "an end that is not in it" "z = 0 is not in its range: z in (0, 1]" [] [ ("z", Rat.zero) ];
  check "twice" "the parameter 'x' is named twice" [ "x"; "x" ] [];
  check "shown and fixed" "the parameter 'x' is named twice" [ "x" ] [ ("x", Rat.one) ];
  check "too many" "one or two parameters can be drawn" [ "x"; "y"; "z" ] [];
  check "none is left" "no parameter has a range to be drawn" []
    [ ("x", Rat.one); ("y", Rat.one); ("z", Rat.one) ]

(* {1 Regions} *)

let outcome : Plane.outcome -> string = function
  | Holds -> "holds"
  | Varies -> "varies"
  | Unknown -> "unknown"
  | Fails -> "fails"
  | Value i -> string_of_int i

let described shown (r : Plane.region) =
  let where = String.concat " or " (List.map (Words.piece shown) (Union.pieces r.set)) in
  String.concat " " (List.map outcome r.outcomes @ [ where; Rat.to_string r.share ])

let regions () =
  let check name expected view checks =
    let shown = Legend.shown ligands view in
    let found = List.map (described shown) (Plane.regions ligands view checks) in
    Alcotest.(check (list string)) name expected found
  in
  check "two checks"
    [ "holds holds 2s + 2 < t 1/9"; "holds fails 2s + 2 = t 0"; "fails fails t < 2s + 2 8/9" ]
    (view ligands [] []) [ possibly; surely ];
  (* what is not known stands in the way of 'holds for all', not of 'depends' *)
  let below a = set 2 [ [ negative 2 (-a) [ 0; 1 ] ] ] and from a = set 2 [ [ not_positive 2 a [ 0; -1 ] ] ] in
  let w = Where.make ligands ~holds:(below 2) ~fails:(from 6) in
  check "depends" [ "varies everywhere 1" ] (view ligands [ "s" ] []) [ w ];
  let w = Where.make ligands ~holds:(below 2) ~fails:(Union.empty 2) in
  check "not known" [ "unknown everywhere 1" ] (view ligands [ "s" ] []) [ w ];
  check "fixed where it holds" [ "holds everywhere 1" ] (view ligands [] [ ("t", Rat.one) ]) [ w ]

(* At points: the outcomes are those of the sets over all values of what is projected. *)
let at_points =
  let gen = G.pair (random_where 3) (random_where 3) in
  let print (a, b) = print a ^ " / " ^ print b in
  QCheck2.Test.make ~name:"outcomes at points" ~count:40 ~print gen (fun ((a, _, _), (b, holds, _)) ->
      let b = decided a.ranges ~holds:(Union.union b.holds holds) in
      let regions = Plane.regions a.ranges (view a.ranges [ "y"; "x" ] []) [ a; b ] in
      let some u x y =
        let fix p i v = Polyhedron.substitute p i (Linear.constant 3 v) in
        List.exists (fun p -> not (Polyhedron.is_empty (fix (fix p 0 x) 1 y))) (Union.pieces u)
      in
      let expected (w : Where.t) x y : Plane.outcome =
        match (some w.holds x y, some w.fails x y, some w.unknown x y) with
        | true, true, _ -> Varies
        | true, false, false -> Holds
        | false, true, false -> Fails
        | _ -> Unknown
      in
      let halves = List.init 13 (fun i -> q (i - 6) 2) in
      let right x y =
        let inside = Ranges.mem a.ranges.(0) x && Ranges.mem a.ranges.(1) y in
        match List.filter (fun (r : Plane.region) -> Planar.mem r.set { x = y; y = x }) regions with
        | [] -> not inside
        | [ r ] -> inside && r.outcomes = [ expected a x y; expected b x y ]
        | _ -> false
      in
      let total = List.fold_left (fun s (r : Plane.region) -> Rat.add s r.share) Rat.zero regions in
      Rat.equal total Rat.one && List.for_all (fun x -> List.for_all (right x) halves) halves)

(* {1 Outlines} *)

let shown_border (b : Outline.border) =
  let p ({ x; y } : Planar.point) = Rat.to_string x ^ "," ^ Rat.to_string y in
  p (fst b.ends) ^ (if b.belongs then " -- " else " .. ") ^ p (snd b.ends)

let unit i = if i = 0 then [ 1; 0 ] else [ 0; 1 ]
let opposite = List.map Int.neg
let above i a = negative 2 a (opposite (unit i)) and below i a = negative 2 (-a) (unit i)
let from i a = not_positive 2 a (opposite (unit i)) and upto i a = not_positive 2 (-a) (unit i)
let at i a = is_zero 2 (-a) (unit i)

let outline_by_hand () =
  let check name expected ~lines ~points pieces =
    let o = Outline.make (set 2 pieces) in
    let sorted = List.sort String.compare in
    Alcotest.(check (list string)) name (sorted expected) (sorted (List.map shown_border o.borders));
    Alcotest.(check (pair int int)) (name ^ ": lines and points") (lines, points)
      (List.length o.lines, List.length o.points)
  in
  check "two squares side by side, of which the one is half open"
    [ "0,0 -- 2,0"; "2,0 .. 2,1"; "2,1 .. 1,1"; "1,1 -- 0,1"; "0,1 -- 0,0" ]
    ~lines:0 ~points:0
    [ [ from 0 0; upto 0 1; from 1 0; upto 1 1 ]; [ above 0 1; below 0 2; from 1 0; below 1 1 ] ];
  (* of the segment one half is a side of the square, the other one goes on; the corner belongs to the square *)
  check "an open square with a segment and two points"
    [ "0,0 -- 1,0"; "1,0 .. 1,1"; "1,1 .. 0,1"; "0,1 .. 0,0" ]
    ~lines:1 ~points:1
    [
      [ above 0 0; below 0 1; above 1 0; below 1 1 ]; [ at 1 0; from 0 0; upto 0 2 ]; [ at 0 3; at 1 0 ];
      [ at 0 1; at 1 1 ];
    ]

(* Green's theorem: around a set that is to the left, the borders enclose its area, whatever its pieces are. *)
let enclosed (o : Outline.t) =
  let term (b : Outline.border) =
    let p, r = b.ends in
    Rat.sub (Rat.mul p.x r.y) (Rat.mul r.x p.y)
  in
  Rat.div (List.fold_left (fun sum b -> Rat.add sum (term b)) Rat.zero o.borders) (q 2 1)

let sets_of_plane = G.map (fun (w, _, _) -> w) (random_where 2)
let print_where w = print (w, (), ())

let areas =
  QCheck2.Test.make ~name:"borders enclose the area" ~count:200 ~print:print_where sets_of_plane (fun w ->
      List.for_all
        (fun u -> Rat.equal (enclosed (Outline.make u)) (Option.get (Where.measure u)))
        [ w.holds; w.fails; w.unknown ])

let belonging =
  QCheck2.Test.make ~name:"borders belong or not, with the set to the left alone" ~count:200 ~print:print_where
    sets_of_plane (fun w ->
        let right u =
          let o = Outline.make u in
          let border (b : Outline.border) =
            let p, r = b.ends in
            (* near one end: the middle may be a corner of a piece *)
            let at = Planar.along b.ends (q 1 97) in
            let tiny = q 1 1000000 in
            let beside sign =
              let move = Rat.mul (Rat.mul sign tiny) in
              { Planar.x = Rat.add at.x (move (Rat.sub p.y r.y)); y = Rat.add at.y (move (Rat.sub r.x p.x)) }
            in
            Planar.mem u at = b.belongs && Planar.mem u (beside Rat.one) && not (Planar.mem u (beside (q (-1) 1)))
          in
          List.for_all border o.borders
        in
        List.for_all right [ w.holds; w.fails; w.unknown ])

(* {1 Axes} *)

let marks () =
  let check name expected range =
    let found = List.map (fun (m : Ticks.mark) -> m.label) (Ticks.marks range) in
    Alcotest.(check (list string)) name expected found
  in
  check "six" [ "0"; "1"; "2"; "3"; "4"; "5"; "6" ] (whole "x" 0 6);
  check "ten" [ "-4"; "-2"; "0"; "2"; "4" ] (whole "x" (-5) 5);
  check "fractions" [ "0.2"; "0.25"; "0.3"; "0.35"; "0.4"; "0.45"; "0.5" ] (range "x" (q 1 6) (q 1 2));
  let tiny = Rat.div Rat.one (Q.of_bigint (Z.pow (Z.of_int 10) 300)) in
  check "tiny" [ "low"; "high" ] (range "x" Rat.one (Rat.add Rat.one tiny))

(* {1 Files} *)

let files () =
  let drawn ranges checks = Drawing.svg ranges (view ranges [] []) checks in
  let contains text part =
    let n = String.length part in
    let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
    from 0
  in
  let text = drawn ligands [ ("tie", tie) ] in
  let has part = Alcotest.(check bool) part true (contains text part) in
  has "where 2s + 2 = t";
  has "no area";
  has "<title>(s, t) = (2, 6)\nA: holds</title>";
  has "lossy";
  Alcotest.(check string) "the same bytes" text (drawn ligands [ ("tie", tie) ]);
  (* 10^-6 wide: less than any pixel *)
  let thin = decided ligands ~holds:(set 2 [ [ below 0 1; negative 2 999999 [ -1000000; 0 ] ] ]) in
  Alcotest.(check bool) "thin sets are seen" true
    (contains (drawn ligands [ ("thin", thin) ]) "fill=\"none\" stroke=\"#4477aa\" stroke-width=\"2\"")

let suite =
  let case name test = Alcotest.test_case name `Quick test in
  ("drawing",
   [
     ("views", [ case "views" views ]);
     ("regions", case "by hand" regions :: Scc_test_support.Property.cases [ at_points ]);
     ("outlines", case "by hand" outline_by_hand :: Scc_test_support.Property.cases [ areas; belonging ]);
     ("axes", [ case "marks" marks ]);
     ("files", [ case "files" files ]);
   ])
