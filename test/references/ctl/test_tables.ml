(* Truth tables checked by hand, one for each operator. *)

open Scc_ctl
open Scc_exact
open Scc_test_ctl
open Timed_formula
open Letters

let table name rows = (name, rows)

let case (name, rows) =
  Alcotest.test_case name `Quick (fun () ->
      List.iter (fun (f, expected, got) -> Alcotest.(check string) (Small.print_formula f) expected got) rows)

(* {1 Connectives} *)

let connectives =
  let g = graph (List.map node [ "TT"; "T."; "T?"; ".T"; ".."; ".?"; "?T"; "?."; "??" ]) in
  table "not, and, or (Kleene)"
    [
      (Not p, "...TTT???", row g (Not p));
      (And [ p; q ], "T.?...?.?", row g (And [ p; q ]));
      (Or [ p; q ], "TTTT.?T??", row g (Or [ p; q ]));
      (And [], "TTTTTTTTT", row g (And []));
      (Or [], ".........", row g (Or []));
    ]

(* {1 Next}

   0 has an edge to 1 (p) and lets 2 pass to 2; 2 has an edge to 3 (not p); 3 is a dead end; 4 rests; 5 goes
   round in time and never takes an edge; 1 is a dead end; 6 is not known. *)
let nexts =
  let g =
    graph
      [
        node ".." ~edges:[ 1 ] ~flow:(Lasts (2, [ 2 ])) ~p:"..." ~q:"...";
        node "T.";
        node ".." ~edges:[ 3 ];
        node "..";
        node ".." ~flow:(Ray 0) ~p:"." ~q:".";
        node ".." ~flow:(Lasts (1, [ 5 ])) ~p:"." ~q:".";
        node ".." ~known:false;
      ]
  in
  table "X: the next edge, after any time"
    [
      (ex p, "T.....?", row g (ex p));
      (ex (Not p), "T.T...?", row g (ex (Not p)));
      (ax p, ".T.TTT?", row g (ax p));
      (ax (Not p), ".TTTTT?", row g (ax (Not p)));
      (ex p, "...", along g (ex p) 0);
      (ex (Not p), "TTT", along g (ex (Not p)) 0);
      (ex (And []), "T.T...?", row g (ex (And [])));
    ]

let pieces =
  let both g = (row g (eu p q), row g (au p q)) in
  let same name g expected =
    let e, a = both g in
    [ (eu p q, expected ^ name, e ^ name); (au p q, expected ^ name, a ^ name) ]
  in
  table "U: instants and open intervals"
    (List.concat
       [
         (* q at the instant 1, p before: met. *)
         same " instant" (from_start "T...." ".T..." "T.") "T.";
         (* p fails at the node itself. *)
         same " not from the start" (from_start "T...." ".T..." "..") "..";
         (* q on (1, 2), and p there: entered. *)
         same " interval with p" (from_start "TTT.." "..T.." "T.") "T.";
         (* q on (1, 2), p only up to the instant 1: there is no first instant of q. *)
         same " interval without p" (from_start "TT..." "..T.." "T.") "..";
         (* but who is inside is there. *)
         [ (eu p q, "..T..", along (from_start "TT..." "..T.." "T.") (eu p q) 0) ];
         [ (eu p q, "TTT..", along (from_start "TTT.." "..T.." "T.") (eu p q) 0) ];
         (* q at the node itself counts, whatever p. *)
         same " at once" (from_start "....." "....." ".T") "T.";
         (* p fails at the instant at which q begins right after. *)
         same " gap" (from_start "T.T.." "..T.." "T.") "..";
       ])

let unbounded =
  table "F and G"
    [
      (ef p, "TT.TTTTT", row runs (ef p));
      (* 5 and 6 may go round for ever within one instant: undecided *)
      (af p, ".T.TT..T", row runs (af p));
      (eg (Not p), "T.T..TT.", row runs (eg (Not p)));
      (ag (Not p), "..T.....", row runs (ag (Not p)));
      (ag p, "....T..T", row runs (ag p));
      (eg p, "....T..T", row runs (eg p));
      (ef p, "TTTT.", along runs (ef p) 1);
      (ag (Not p), "....T", along runs (ag (Not p)) 1);
      (af (ag p), "...TT..T", row runs (af (ag p)));
      (ef (eg p), "...TTTTT", row runs (ef (eg p)));
    ]

let zeno =
  let good = zeno_then (node "T.") and bad = zeno_then (node "..") in
  table "cycles without duration"
    [
      (* a run that goes round for ever within one instant is a run, and has no p *)
      (af p, "..T", row good (af p));
      (af p, "...", row bad (af p));
      (eg (Not p), "TT.", row good (eg (Not p)));
      (eg (Not p), "TTT", row bad (eg (Not p)));
      (eg (And []), "TTT", row good (eg (And [])));
      (ag (ex (And [])), "...", row good (ag (ex (And []))));
      (ef p, "TTT", row good (ef p));
      (ag (Not p), "...", row good (ag (Not p)));
      (af ~b:(bound 0 ~high:1) p, "..T", row good (af ~b:(bound 0 ~high:1) p));
      (af ~b:(bound 0 ~high:0) p, "..T", row good (af ~b:(bound 0 ~high:0) p));
      (* time 1 never comes on it, so that nothing is at time 1 *)
      (au ~b:(bound 1) (And []) p, "...", row good (au ~b:(bound 1) (And []) p));
      (eg ~b:(bound 1) p, "TTT", row good (eg ~b:(bound 1) p));
      (* 2 ends before time 1 as well *)
      (eu ~b:(bound 1) (And []) p, "TT.", row good (eu ~b:(bound 1) (And []) p));
      (* a loop that takes time *)
      (af p, ".", row (graph [ node ".." ~flow:(Lasts (1, [ 0 ])) ~p:"." ~q:"." ]) (af p));
    ]

(* 0 is a dead end without p, 1 one with p and q; 2 chooses between them, 3 lets 1 pass to 0. *)
let dead_ends =
  let g =
    graph
      [ node ".."; node "TT"; node ".T" ~edges:[ 0; 1 ]; node ".T" ~flow:(Lasts (1, [ 0 ])) ~p:"." ~q:"T" ]
  in
  let now = bound 0 ~high:0 and later = bound 1 ~high:2 in
  table "dead ends"
    [
      (ex (And []), "..T.", row g (ex (And [])));
      (ax (Or []), "TT.T", row g (ax (Or [])));
      (ef p, ".TT.", row g (ef p));
      (af p, ".T..", row g (af p));
      (af (ex (And [])), "..T.", row g (af (ex (And []))));
      (eg q, ".TT.", row g (eg q));
      (ag q, ".T..", row g (ag q));
      (eg (And []), "TTTT", row g (eg (And [])));
      (eu q p, ".TT.", row g (eu q p));
      (au q p, ".T..", row g (au q p));
      (au q (And []), "TTTT", row g (au q (And [])));
      (ef ~b:now p, ".TT.", row g (ef ~b:now p));
      (ef ~b:later (And []), "...T", row g (ef ~b:later (And [])));
      (af ~b:later (And []), "...T", row g (af ~b:later (And [])));
      (ag ~b:later (Or []), "TTT.", row g (ag ~b:later (Or [])));
      (eg ~b:later (Or []), "TTT.", row g (eg ~b:later (Or [])));
      (eu ~b:later q (Not q), "...T", row g (eu ~b:later q (Not q)));
      (au ~b:later q (Not q), "...T", row g (au ~b:later q (Not q)));
    ]

let bounded =
  let within high = bound 0 ~high in
  let both f g expected b = [ (f ~b p, expected, row g (f ~b p)) ] in
  table "[0, b]"
    (List.concat
       [
         (* the bound is closed: 3 is met exactly; p on (1, 2) is after 1 *)
         both (fun ~b f -> ef ~b f) line "TTTTT" (within 3);
         both (fun ~b f -> af ~b f) line "TTTTT" (within 3);
         both (fun ~b f -> ef ~b f) line ".TTTT" (within 2);
         both (fun ~b f -> af ~b f) line ".TTT." (within 2);
         both (fun ~b f -> ef ~b f) line ".TT.." (within 1);
         both (fun ~b f -> ef ~b f) line "..T.." (within 0);
         (* at 3 - 2: the cut is at offset 1 of the flow of 0, and the instant belongs to it *)
         [ (ef ~b:(within 2) p, ".TT", along line (ef ~b:(within 2) p) 0) ];
         (* in the flow of 3: p is met in time from offset 0 on, also from 4 - 1 on to the end *)
         [ (ef ~b:(within 1) p, "TTT..TT", along line (ef ~b:(within 1) p) 3) ];
         [ (ag ~b:(within 2) (Not p), "T....", row line (ag ~b:(within 2) (Not p))) ];
         [ (eg ~b:(within 2) (Not p), "T...T", row line (eg ~b:(within 2) (Not p))) ];
         [ (eu ~b:(within 3) q p, "..T..", row line (eu ~b:(within 3) q p)) ];
         (* a run that is over before the bound: F is not met, G is kept *)
         [ (af ~b:(within 9) q, ".....", row line (af ~b:(within 9) q)) ];
         [ (ag ~b:(within 9) (Not q), "TTTTT", row line (ag ~b:(within 9) (Not q))) ];
       ])

let intervals =
  let exactly n = bound n ~high:n in
  table "[a, b]"
    [
      (ef ~b:(exactly 3) p, "T...T", row line (ef ~b:(exactly 3) p));
      (ef ~b:(exactly 1) p, ".T...", row line (ef ~b:(exactly 1) p));
      (* on (1, 2), and not at 2 *)
      (ef ~b:(exactly 2) p, ".....", row line (ef ~b:(exactly 2) p));
      (ef ~b:(bound 1 ~high:2) p, ".T.TT", row line (ef ~b:(bound 1 ~high:2) p));
      (* runs that stop before the low end fail *)
      (af ~b:(bound 1) p, "TT.TT", row line (af ~b:(bound 1) p));
      (af ~b:(bound 4) p, "...T.", row line (af ~b:(bound 4) p));
      (ag ~b:(bound 4) p, "TTTTT", row line (ag ~b:(bound 4) p));
      (ag ~b:(bound 5) p, "TTTTT", row line (ag ~b:(bound 5) p));
      (ag ~b:(bound 3 ~high:3) p, "TTT..", row line (ag ~b:(bound 3 ~high:3) p));
      (* the first position at the low end: before what happens there *)
      ( eu ~b:(exactly 2) (Not q) (Not p), "T..TT", row line (eu ~b:(exactly 2) (Not q) (Not p)) );
      (* inside the flow of 3, p is met exactly 1 later: at 0 < o < 1, and at the end *)
      (ef ~b:(exactly 1) p, "T....T.", along line (ef ~b:(exactly 1) p) 3);
      (* an interval that is empty *)
      (ef ~b:(bound 3 ~high:2) (And []), ".....", row line (ef ~b:(bound 3 ~high:2) (And [])));
    ]

let unknown =
  let within high = bound 0 ~high in
  table "nodes that are not known"
    [
      (ef p, "??.??", row truncated (ef p));
      (* a run that is known avoids p *)
      (af p, ".?.??", row truncated (af p));
      (ag (Not p), "??T??", row truncated (ag (Not p)));
      (eg (Not p), "T?T??", row truncated (eg (Not p)));
      (* the bound is passed before *)
      (af ~b:(within 4) p, ".?..?", row truncated (af ~b:(within 4) p));
      (ef ~b:(within 4) p, "??..?", row truncated (ef ~b:(within 4) p));
      (af ~b:(within 5) p, ".?.??", row truncated (af ~b:(within 5) p));
      (ef (Not p), "TTTTT", row truncated (ef (Not p)));
      (eu q p, ".....", row truncated (eu q p));
    ]

(* {1 Irrational cuts}

   From 0 time passes for 2 to the dead end 1; p holds from the root of 2 on. *)
let root = List.hd (Algebraic.roots (Polynomial.of_coefficients (List.map Rat.of_int [ -2; 0; 1 ]))
                      ~low:Rat.zero ~high:None)

let irrational () =
  let two = Rat.of_int 2 in
  let graph : Timed_graph.t =
    {
      size = 2;
      known = (fun _ -> true);
      edges = (fun _ -> [||]);
      drawn = (fun _ -> None);
      flow = (fun s -> if s = 0 then Lasts (two, [| 1 |]) else No_flow);
    }
  in
  let along _ _ extent =
    Timeline.refine
      ~roots:(fun () -> [ root ])
      ~at:(fun r () -> Truth.of_bool (Algebraic.compare r root >= 0))
      ~inside:(fun r () -> Truth.of_bool (Algebraic.compare_rat root r < 0))
      (Timeline.constant extent ())
  in
  let e =
    Eval.create (Timed_graph.index graph)
      { at = (fun _ _ -> Truth.False); along; steady = (fun _ -> false) }
  in
  let truth f offset = letter (Eval.truth e f { Positions.node = 0; offset }) in
  let check text expected f offset = Alcotest.(check string) text expected (truth f offset) in
  let cut = Algebraic.add_rat (Rat.of_int (-1)) root in
  let close = Algebraic.of_rat (Algebraic.between cut (Algebraic.of_rat (Rat.make Z.one (Z.of_int 2)))) in
  let before = Algebraic.of_rat (Algebraic.between (Algebraic.of_rat (Rat.make (Z.of_int 2) (Z.of_int 5))) cut) in
  let f = ef ~b:(bound 0 ~high:1) p in
  check "at 0" "." f Algebraic.zero;
  check "before root 2 - 1" "." f before;
  check "at root 2 - 1" "T" f cut;
  check "after it" "T" f close;
  let g = ef ~b:(bound 1 ~high:1) p in
  check "exactly 1 later, before" "." g before;
  check "exactly 1 later, at" "T" g cut;
  let hundredths n = ef ~b:{ low = Rat.zero; high = Some (Rat.make (Z.of_int n) (Z.of_int 100)) } p in
  check "within 1.41" "." (hundredths 141) Algebraic.zero;
  check "within 1.42" "T" (hundredths 142) Algebraic.zero

let suite =
  let quick name f = Alcotest.test_case name `Quick f in
  let all = [ connectives; nexts; pieces; unbounded; zeno; dead_ends; bounded; intervals; unknown ] in
  ("tables", [ ("operators", List.map case all @ [ quick "irrational cuts" irrational ]) ])
