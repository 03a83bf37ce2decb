(* Help in writing: what can be written at a place, new names, fixes of hints, and a text as a whole. By hand,
   and at every place of every model. *)

open Scc_base
open Scc_describe
open Scc_assist
open Texts

(* {1 Completion} *)


let shapes =
  "shape A { vertices p (0,0,0) q (1,0,0) faces f [p,q] }\n\
   shape B { vertices u (0,0,0) faces g [u] }\n\
   shape C = B scaled (1,1,1)\n\
   compound D { part left : A mass 1 part right : B mass 1 glue left.f ~ right.g }\n"

let one = shapes ^ "process one = A mass 1 [<~ink, {f}>. nil]\n"

let just text wanted () = texts text (List.sort compare wanted) (List.sort compare (names (one ^ text)))

let among text wanted absent () =
  let found = names (one ^ text) in
  List.iter (fun n -> Alcotest.(check bool) (text ^ n) true (List.mem n found)) wanted;
  List.iter (fun n -> Alcotest.(check bool) ("not " ^ text ^ n) false (List.mem n found)) absent

let solids = [ "A"; "B"; "C"; "D"; "box"; "prism"; "antiprism"; "pyramid" ]

let completion =
  [
    case "channels" (just "process two = C mass 1 [<" [ "ink" ]);
    case "channels of weak splits" (just "behaviour X on A = omega(" [ "ink" ]);
    case "features of an image" (just "process two = C mass 1 [<ink, {" [ "u"; "g"; "only"; "one"; "two" ]);
    case "features on a shape" (just "behaviour X on A = omega(ink, {" [ "p"; "q"; "f"; "only" ]);
    case "features of a compound"
      (just "behaviour X on D = <ink, {"
         [ "left"; "left.p"; "left.q"; "left.f"; "right"; "right.u"; "right.g"; "only" ]);
    case "features of a part" (just "behaviour X on D = <ink, {left." [ "p"; "q"; "f" ]);
    case "features of who has a behaviour"
      (just "process two = B [First]\nbehaviour First = <ink, {g}>. Next\nbehaviour Next = <ink, {"
         [ "u"; "g"; "only" ]);
    case "features of a predefined solid"
      (among "process two = prism(3, 1, 1) mass 1 [<ink, {" [ "side3"; "top" ] [ "side4"; "p" ]);
    case "features of a body" (just "bond <ink, {one." [ "p"; "q"; "f" ]);
    case "nothing but a bracket" (just "process two = C mass 1 [<ink, " []);
    case "shapes" (just "behaviour X on " solids);
    case "shapes that begin alike" (just "process two = an" [ "antiprism" ]);
    case "in a comment" (just "// a comment <" []);
    case "in a comment of several lines" (just "/* a comment\nprocess two = " []);
    case "in a text" (just "import \"" []);
    case "attributes" (among "process two = C " [ "mass"; "velocity"; "at" ] [ "left" ]);
    case "values of a setting" (just "dynamics " [ "constant_spin"; "free_body" ]);
    case "events" (just "check c : event " [ "bind"; "weak"; "strong"; "split"; "bounce"; "absorb"; "hit" ]);
    case "formulas" (among "check c : " [ "always"; "eventually"; "bound"; "one" ] []);
    case "no declarations in a formula"
      (among "check c : " [] [ "process"; "shape"; "import"; "motion"; "velocity" ]);
    case "nor later in it"
      (among "check c : always (true and " [] [ "process"; "compound"; "split_step"; "scaled" ]);
    case "laws" (among "motion one = (" [ "vx"; "time"; "dt" ] [ "bound" ]);
    case "what a module brings" (just "import \"parts.sc\" as m\nprocess two = m." [ "Tile"; "Pin"; "width" ]);
    case "features of what a module brings"
      (just "import \"parts.sc\" as m\nprocess two = m.Pin mass 1 [<ink, {" [ "tip"; "f"; "only"; "one"; "two" ]);
    case "features of the library"
      (among "import <solids>\nprocess two = solids.Cube(2) mass 1 [<ink, {" [ "left"; "top" ] [ "p" ]);
    case "bodies that an atom takes" (just "process two = A [nil]\ncheck c : bound(one, " [ "one"; "two" ]);
    case "one body, not those of a process of several"
      (just "process two = a : A [nil] <ink, {a.f, b.f}> b : A [nil]\ncheck c : always x(" [ "one"; "a"; "b" ]);
    case "a body and a channel" (just "check c : event bind(ink, one, " [ "one" ]);
    case "a channel" (just "check c : offers(one, " [ "ink" ]);
    case "bodies of a quantifier"
      (just "check c : always forall b in A: forall i in 1..3: x(" [ "one"; "b" ]);
    case "no more within an argument" (just "check c : always x(one + " []);
    case "a behaviour to compare with" (just "behaviour K = nil\ncheck c : behaviour(one) = " [ "K" ]);
    case "a dot after a body" (just "check c : always one." []);
    case "parts that are hit" (just "process two = D [nil]\ncheck c : event hit(two." [ "left"; "right" ]);
    case "a process in a loop"
      (just "behaviour K on A = nil\nfor i in 1..2 { process two[i] = A mass 1 ["
         [ "K"; "nil"; "omega"; "rho"; "eps" ]);
    case "no behaviour for another shape"
      (just "behaviour K on B = nil\nprocess two = A mass 1 [" [ "nil"; "omega"; "rho"; "eps" ]);
    case "behaviours of a module alone" (just "import \"parts.sc\" as m\nprocess two = A mass 1 [m." []);
    case "components" (among "let v = (1, 2, 3)\nlet w = v." [ "x"; "y"; "z" ] []);
  ]

let imports () =
  let at text = Completion.import text (String.length text) in
  let is what text wanted = Alcotest.(check bool) what true (at text = wanted) in
  is "a file" "import \"lib/pa" (Some (8, `File "lib/pa"));
  is "a module" "model m\nimport <so" (Some (16, `Library));
  is "after a file" "import \"a.sc\" " None;
  is "elsewhere" "process p" None

(* Each name of each model is offered where it stands, and where its first letter stands: there if it stands
   elsewhere as well. *)
let everywhere () =
  let count = Hashtbl.create 8 in
  let model (file, text) =
    let r = reading text in
    let occurs name =
      let is_it (t : Scc_syntax.Tokens.token) =
        match t.token with
        | BARRED n -> String.equal n name
        | _ -> String.equal (String.sub text t.start (t.stop - t.start)) name
      in
      List.length (List.filter is_it (Array.to_list (Lazy.force r.tokens).tokens))
    in
    let known = Known.of_text modules r in
    let stands kind (at : Span.t) name =
      Hashtbl.replace count kind (1 + Option.value ~default:0 (Hashtbl.find_opt count kind));
      let offered offset = snd (Completion.at known text offset) in
      let is (o : Completion.offer) = List.hd (String.split_on_char '.' o.name) = name in
      let fail place = Alcotest.failf "%s: %s, a %s, %s %d" file name kind place at.start in
      if not (List.exists is (offered at.start)) then fail "at";
      if List.exists is (offered (at.start + 1)) <> (occurs name > 1) then fail "at its first letter, after"
    in
    let is_plain (at : Span.t) = Char.code text.[at.start] < 128 in
    let use at (u : Scope.use) =
      (* some of each text *)
      if at mod 5 = 0 then match Lazy.force u.meaning with
        | Channel when is_plain u.name.at -> stands "channel" u.name.at u.name.it
        | Declared ({ kind = Behaviour; name; _ } :: _) when name.at.start <> u.name.at.start ->
          stands "behaviour" u.name.at u.name.it
        | Declared ({ kind = Shape | Compound; name; _ } :: _) when name.at.start <> u.name.at.start ->
          stands "shape" u.name.at u.name.it
        | _ -> ()
    in
    Hashtbl.iter use (Lazy.force r.uses).uses
  in
  List.iter model (all_models ());
  let several kind n = Alcotest.(check bool) (Printf.sprintf "%d of the kind %s" n kind) true (n > 10) in
  Hashtbl.iter several count

(* {1 Forms} *)

(* Each word of formulas, laws and solids that is called has a form, and each form is of a word. *)
let forms () =
  let called (e : Vocabulary.entry) =
    match e.category with
    | Function | Solid -> true
    | Atom -> not (List.mem e.word [ "processes"; "momentum"; "angular"; "energy"; "time"; "quiescent" ])
    | _ -> false
  in
  List.iter
    (fun (e : Vocabulary.entry) ->
       if called e && Forms.find Called e.word = None then Alcotest.failf "`%s` has no form" e.word;
       if e.category = Event && Forms.find Event e.word = None then Alcotest.failf "`event %s` has no form" e.word)
    Vocabulary.all;
  let known word = List.exists (fun (e : Vocabulary.entry) -> e.word = word) Vocabulary.all in
  let is_word (e : Forms.entry) = if not (known e.word) then Alcotest.failf "`%s` is no word" e.word in
  List.iter is_word Forms.all

let signature text wanted argument () =
  match Signatures.at (Known.of_text modules (reading (one ^ text))) (one ^ text) (String.length (one ^ text)) with
  | None -> if wanted <> [] then Alcotest.failf "no call in `%s`" text
  | Some c ->
    texts text wanted c.forms;
    Alcotest.(check int) "argument" argument c.argument

let signatures =
  [
    case "an atom" (signature "check c : bound(one, " [ "bound(body, body)" ] 1);
    case "an event" (signature "check c : event weak(" [ "weak"; "weak(channel)"; "weak(channel, body, body)" ] 0);
    case "within brackets" (signature "check c : bound(one, (1 + " [ "bound(body, body)" ] 1);
    case "after a call" (signature "check c : bound(one, one) and " [] 0);
    case "a family" (signature "behaviour K(a, b) = nil\nprocess two = A [K(ink, " [ "K(a, b)" ] 1);
    case "in another declaration" (signature "check c : bound(one,\nprocess two = " [] 0);
  ]

(* {1 New names} *)

let renamed text piece ?nth name =
  let r = reading text in
  match Names.at r (place ?nth text piece) with
  | None -> Alcotest.failf "nothing is named at `%s`" piece
  | Some o -> Result.map (Rename.apply text) (Rename.edits r o.target name)

let becomes text piece name wanted () =
  match renamed text piece name with
  | Ok found -> Alcotest.(check string) piece wanted found
  | Error why -> Alcotest.failf "refused: %s" why

let refused text piece name () =
  match renamed text piece name with
  | Ok found -> Alcotest.failf "not refused: %s" found
  | Error _ -> ()

let small =
  "shape A = box(1,1,1)\nlet k = 2\n\
   for i in 1..k { process p[i] = A at translate (i, 0, 0) [<a, {top}>. K] }\n\
   behaviour K = <~a, {top}>. nil\ncheck c : always x(p[1]) > k\n"

let renaming =
  [
    case "a shape"
      (becomes "shape A = box(1,1,1)\nprocess p = A [nil]\n" "A" "B"
         "shape B = box(1,1,1)\nprocess p = B [nil]\n");
    case "a variable of a loop"
      (becomes "for i in 1..2 { process p[i] = box(i,1,1) [nil] }\nlet i = 3" "i in" "k"
         "for k in 1..2 { process p[k] = box(k,1,1) [nil] }\nlet i = 3");
    case "a channel, its co-name and a bar"
      (becomes "process p = box(1,1,1) [<a, {top}>. <~a, {top}>. <ā, {top}>. nil]" "a, " "bb"
         "process p = box(1,1,1) [<bb, {top}>. <~bb, {top}>. <~bb, {top}>. nil]");
    case "a face, through an image"
      (becomes (shapes ^ "process p = C [<a, {g}>. nil]") "g [" "h"
         "shape A { vertices p (0,0,0) q (1,0,0) faces f [p,q] }\n\
          shape B { vertices u (0,0,0) faces h [u] }\nshape C = B scaled (1,1,1)\n\
          compound D { part left : A mass 1 part right : B mass 1 glue left.f ~ right.h }\n\
          process p = C [<a, {h}>. nil]");
    case "to a keyword" (refused small "A" "process");
    case "to a word that can be a name" (refused small "A" "bond");
    case "to no name" (fun () ->
        let refuse name = refused small "A" name (); refused small "K" name (); refused small "a, " name () in
        List.iter refuse [ "1a"; "_"; "_a"; "__"; "_1"; "'a"; "a-b"; "a b"; "a.b"; ""; " a"; "a "; "é"; "aé" ]);
    case "to what is declared" (refused small "A" "K");
    case "to a variable that would capture"
      (refused "let k = 2\nfor i in 1..3 { process p[i] = box(k, i, 1) [nil] }\n" "k = " "i");
    case "to another channel" (refused "process p = box(1,1,1) [<a, {top}>. <b, {top}>. nil]" "a, " "b");
    case "to a corner of the same shape" (refused one "f [" "p");
    case "a feature of a predefined solid" (fun () ->
        Alcotest.(check bool) "none" true (Names.at (reading small) (place small "top") = None));
    case "in a text with an error" (refused (small ^ "process q = [") "A" "B");
    case "a module without an alias" (refused "import \"parts.sc\"\nprocess p = parts.Pin [nil]" "parts.Pin" "q");
    case "a face that may be of another shape"
      (refused
         "shape A { vertices p (0,0,0) faces f [p] }\nshape B { vertices p (0,0,0) faces f [p] }\n\
          behaviour K = <a, {f}>. nil"
         "f [" "g");
  ]

(* Every name of every model can get a new one, but those that are refused with a reason; the old one brings the
   text back. *)
let there_and_back () =
  let count = ref 0 in
  let model (file, text) =
    let r = reading text in
    let is_own (o : Names.occurrence) = match o.target with There _ | Several _ -> false | _ -> o.declares in
    let targets = List.filter is_own (Names.all r) in
    let one (o : Names.occurrence) =
      let old = String.sub text o.at.start (o.at.stop - o.at.start) in
      if String.for_all (fun c -> Char.code c < 128) old then
        match Rename.edits r o.target "fresh'1" with
        | Error why -> if String.length why < 20 then Alcotest.failf "%s: %s: %s" file old why
        | Ok edits -> (
            let after = Rename.apply text edits in
            let again = reading after in
            let bars = List.exists (fun ((at : Span.t), _) -> Char.code text.[at.start] >= 128) edits in
            match Names.at again (fst (List.hd edits)).start with
            | None -> Alcotest.failf "%s: `%s` is not named any more" file old
            | Some o -> (
                incr count;
                match Rename.edits again o.target old with
                | Ok back ->
                  if not bars then Alcotest.(check string) (file ^ ": " ^ old) text (Rename.apply after back)
                | Error why -> Alcotest.failf "%s: back to `%s`: %s" file old why))
    in
    List.iteri (fun i o -> if i mod 17 = 3 then one o) targets
  in
  List.iter model (all_models ());
  Alcotest.(check bool) "a hundred names" true (!count > 100)

(* {1 Fixes} *)

let fixed text wanted () =
  let found = load text in
  match List.concat_map (Fixes.of_diagnostic (reading text)) found with
  | f :: _ -> Alcotest.(check string) f.title wanted (Rename.apply text f.edits)
  | [] ->
    let messages = List.map (fun (d : Diag.t) -> d.message) found in
    Alcotest.failf "nothing mends %s" (String.concat "; " messages)

let cube = "shape Cube = box(1,1,1)\n"
let after_cube text wanted = fixed (cube ^ text) (cube ^ wanted)

let fixes =
  [
    case "a name" (after_cube "process p = Kube mass 1 [nil]" "process p = Cube mass 1 [nil]");
    case "a feature"
      (after_cube "process p = Cube mass 1 [<a, {tpp}>. nil]" "process p = Cube mass 1 [<a, {top}>. nil]");
    case "a word" (after_cube "proces p = Cube mass 1 [nil]" "process p = Cube mass 1 [nil]");
    case "a product" (after_cube "let b = 2a" "let b = 2*a");
    case "a word of two letters"
      (after_cube "process p = Cube mass 1 [nil] check c : A F x(p) = 0"
         "process p = Cube mass 1 [nil] check c : AF x(p) = 0");
    case "what is not used"
      (after_cube "let b = 2\nprocess p = Cube mass 1 [nil]\n" "process p = Cube mass 1 [nil]\n");
    case "a predefined solid needs no import"
      (fixed "import <solids>\nprocess p = solids.box(1,1,1) mass 1 [nil]\n"
         "import <solids>\nprocess p = box(1,1,1) mass 1 [nil]\n");
    case "a name that an import has"
      (fixed "import <solids> as s\nprocess p = Cube(1) mass 1 [nil]\n"
         "import <solids> as s\nprocess p = s.Cube(1) mass 1 [nil]\n");
  ]

(* Each suggested name of the conformance suite's invalid models is put in: then this error is not there any
   more. *)
let suggestions () =
  let count = ref 0 in
  let model (file, text) =
    let text_reading = reading text in
    let found = load text in
    let same (a : Diag.t) (b : Diag.t) =
      a.code = b.code && a.span.start = b.span.start && a.message = b.message
    in
    let one (d : Diag.t) =
      match (Option.fold ~none:[] ~some:Diag.suggestions d.hint, Fixes.of_diagnostic text_reading d) with
      | _ :: _, [] -> Alcotest.failf "%s: %s has a suggestion and no fix" file d.message
      | _ :: _, f :: _ ->
        incr count;
        if List.exists (same d) (load (Rename.apply text f.edits)) then
          Alcotest.failf "%s: %s is not mended" file d.message
      | [], _ -> ()
    in
    List.iter one found
  in
  List.iter model (models "../../../specs/conformance/invalid");
  Alcotest.(check bool) (Printf.sprintf "%d suggestions" !count) true (!count >= 4)

(* {1 A text as a whole} *)

let rec nested (n : Outline.node) =
  let within (a : Span.t) (b : Span.t) = a.start <= b.start && b.stop <= a.stop in
  if not (within n.at n.name_at) then Alcotest.failf "the name of %s is not within it" n.name;
  let child (i : Outline.node) =
    if not (within n.at i.at) then Alcotest.failf "%s is not within %s" i.name n.name;
    nested i
  in
  List.iter child n.inner

let whole text =
  let r = reading text in
  List.iter nested (Outline.of_text r);
  let fold (f : Outline.fold) = if f.from > f.upto || f.upto > String.length text then Alcotest.fail "a fold" in
  List.iter fold (Outline.folds r);
  let word last (w : Colours.word) =
    if w.start < last || w.stop <= w.start then Alcotest.failf "a word at %d" w.start;
    w.stop
  in
  ignore (List.fold_left word 0 (Colours.of_text r));
  ignore (Names.all r);
  r

let outline () =
  let told (n : Outline.node) = (n.name, n.kind, List.length n.inner) in
  let found = List.map told (Outline.of_text (reading small)) in
  Alcotest.(check (list (triple string string int))) "tree"
    [
      ("A", "shape", 0); ("k", "value", 0); ("for i in 1..k", "loop", 1); ("K", "behaviour", 0); ("c", "check", 0);
    ]
    found

(* A share of all beginnings of all models: something is said of each that is no model, at a place of the text, and
   all the rest has an answer. SCC_TIMES=100 looks at every byte. *)
let prefixes () =
  let times = match Sys.getenv_opt "SCC_TIMES" with Some n -> int_of_string n | None -> 1 in
  let step = Int.max 1 (397 / times) in
  let one file text n =
    let part = String.sub text 0 n in
    let source = Source.make ~name:"m.sc" part in
    (match Scc_loading.Loaded.load ~read_file:(fun _ -> Error "no files") ~overrides:[] source with
     | Ok _ -> ()
     | Error [] -> Alcotest.failf "%s: nothing is said of its first %d bytes" file n
     | Error found ->
       List.iter
         (fun (d : Diag.t) ->
            if d.span.stop > n && d.span.file = "m.sc" then
              Alcotest.failf "%s: %s beyond its first %d bytes" file d.message n)
         found);
    let r = whole part in
    let known = Known.of_text modules r in
    ignore (Completion.at known part n);
    ignore (Signatures.at known part n);
    ignore (Completion.import part n)
  in
  let model i (file, text) =
    let n = String.length text in
    let rec from k =
      if k <= n then begin
        one file text k;
        from (k + step)
      end
    in
    from (i mod step);
    one file text n
  in
  List.iteri model (all_models ())

let () =
  Alcotest.run "assist"
    [
      ("completion", completion @ [ case "imports" imports; case "every name of every model" everywhere ]);
      ("calls", case "every word that is called" forms :: signatures);
      ("new names", renaming @ [ case "there and back" there_and_back ]);
      ("fixes", fixes @ [ case "suggestions" suggestions ]);
      ("whole texts", [ case "outline" outline; case "beginnings of all models" prefixes ]);
    ]
