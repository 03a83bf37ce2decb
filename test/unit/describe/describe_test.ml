(* What is told of a place of a text: by hand, in texts full of faults, and at every byte of every model. *)

open Scc_base
open Scc_syntax
open Scc_describe

let case name f = Alcotest.test_case name `Quick f
let check_text = Alcotest.(check string)

let read file =
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  text

let parts = {|// parts
param width = 2
shape Tile(a) = box(a, a, width)
behaviour Sticky = <paste, {top}>. nil
|}

let modules ~library name =
  if library then Scc_elaborate.Library.find name else if name = "parts.sc" then Some parts else None

let find text = Describe.find ~read_module:modules (Source.make ~name:"m.sc" text)

let place = Scc_test_support.Piece.place

let name_of = Option.map (fun (d : Describe.t) -> d.name)
let first_line s = List.hd (String.split_on_char '\n' s)
let told text offset = match find text offset with Some d -> d | None -> Alcotest.failf "nothing at %d" offset

(* {1 By hand} *)

let model = {|model small
import "parts.sc" as t
import <solids> (Chamfered as Cut)
param speed = 3
param early in [0, 6)
let far = 2*speed
timestep 1/4 steady
dynamics free_body
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]  right [b,c,g,f]  front [a,b,f,e]  back [d,h,g,c]
}
shape Long = Cube scaled (2, 1, 1)
compound Pair {
  part one : Cube mass 1
  part two : Cube mass 1 at translate (2, 0, 0)
  glue one.right ~ two.left
}
behaviour Open on Long = <dock, {right}>. Key(arm, left)
behaviour Key(ch, side) = <~ch, {side}>. eps(late). omega(ch, {side}). nil where late = early + 1
behaviour Wait[i] = eps(i). Wait[i - 1]
process p = Cube mass far velocity (speed, 0, 0) [Open]
process q = u : Cube mass 1 [Wait[2]] <dock, {u.right, v.left}> v : Long mass 1 at translate (3, 0, 0) [nil]
for k in 1..4 if k != 2 { process row[k] = t.Tile(k) mass 1 at translate (0, 9*k, 0) [nil] }
process cut = Cut(2, 1/4) mass 1 at translate (0, 0, 50) [t.Sticky]
fixed wall = Pair at translate (50, 0, 0)
motion p = (vx, vy, -10*dt)
check meets : possibly forall r in row: distance2(p, r) <= far and bonds(dock) = 1 within early
check sees : always (event hit(p, wall.one) => offers(q, ~arm)) and max(x(p), time) < 9 and momentum.z = 0
|}

(* A piece of the model, where in it the name stands, its kind, the first line, and where it is declared. *)
let by_hand =
  [
    ("model small", 6, "model", "the model is called `small`", "small");
    ("as t", 3, "module", "the module of the file \"parts.sc\"", "t\nimport");
    ("\"parts.sc\"", 0, "module", "the module of the file \"parts.sc\"", "t\nimport");
    ("<solids>", 1, "module", "the library's module <solids>", "solids");
    ("(Chamfered", 1, "shape", "shape `Chamfered(a, c)`: 24 vertices and 26 faces, from <solids>", "Cut)");
    ("= Cut(", 2, "shape", "shape `Chamfered(a, c)`: 24 vertices and 26 faces, from <solids>", "Cut)");
    ("t.Tile", 0, "module", "the module of the file \"parts.sc\"", "t\nimport");
    ("t.Tile", 2, "shape", "shape `Tile(a)`: box(a, a, width), from \"parts.sc\"", "t\nimport");
    ("t.Sticky", 2, "behaviour", "behaviour `Sticky`, from \"parts.sc\"", "t\nimport");
    ("speed, 0", 0, "parameter", "parameter `speed`, 3 if nothing else is given", "speed = 3");
    ("early + 1", 0, "parameter", "parameter `early`, any number in [0, 6)", "early in");
    ("within early", 7, "parameter", "parameter `early`, any number in [0, 6)", "early in");
    ("mass far", 5, "value", "value `far`", "far = 2");
    ("late)", 0, "value", "value `late`, for `Key(ch, side)` alone", "late = early");
    ("ch, {side}>", 0, "argument", "`ch`: an argument of `Key(ch, side)`", "ch, side) =");
    ("side}>", 0, "argument", "`side`: an argument of `Key(ch, side)`", "side) =");
    ("Wait[i - 1]", 5, "argument", "`i`: an argument of `Wait[i]`", "i] = eps");
    ("Cube scaled", 0, "shape", "shape `Cube`: 8 vertices and 6 faces", "Cube {");
    ("Long mass", 0, "shape", "shape `Long`: Cube scaled (2, 1, 1)", "Long = Cube");
    ("f,g,h]", 0, "vertex", "vertex `f` of `Cube`, at (1, -1, 1)", "f (1,-1,1)");
    ("{right}", 1, "face", "face `right` of `Cube`, with the corners b, c, g, f", "right [b");
    ("v.left", 2, "face", "face `left` of `Cube`, with the corners a, e, h, d", "left [a");
    ("arm, left", 5, "face", "face `left` of `Cube`, with the corners a, e, h, d", "left [a");
    ("one.right", 0, "part", "part `one` of `Pair`: Cube, mass 1", "one : Cube");
    ("wall.one", 5, "part", "part `one` of `Pair`: Cube, mass 1", "one : Cube");
    ("= Pair", 2, "compound", "compound `Pair`: 2 parts, 1 glue", "Pair {");
    ("[Open]", 1, "behaviour", "behaviour `Open`, for `Long`", "Open on");
    ("Key(arm", 0, "behaviour", "family of behaviours `Key(ch, side)`", "Key(ch");
    ("Wait[2]", 0, "behaviour", "family of behaviours `Wait[i]`", "Wait[i] =");
    ("dock, {right", 0, "channel", "channel `dock`", "");
    ("Key(arm", 4, "channel", "channel `arm`", "");
    ("~arm", 1, "channel", "channel `arm`", "");
    ("p = Cube", 0, "process", "process `p`: Cube, mass far, velocity (speed, 0, 0), behaves as Open", "p = Cube");
    ("hit(p", 4, "process", "process `p`: Cube, mass far, velocity (speed, 0, 0), behaves as Open", "p = Cube");
    ("q, ~arm", 0, "process", "process `q`: 2 bodies that are bound", "q = u");
    ("u.right", 0, "leaf", "body `u` of the process `q`: Cube, mass 1, behaves as Wait[2]", "u : Cube");
    ("row: dist", 0, "process", "process `row[k]`: t.Tile(k), mass 1", "row[k]");
    ("wall.one", 0, "fixed", "fixed body `wall`: Pair", "wall = Pair");
    ("k != 2", 0, "index", "`k`: an integer, any of 1..4 for which k != 2", "k in 1");
    ("9*k", 2, "index", "`k`: an integer, any of 1..4 for which k != 2", "k in 1");
    ("r) <=", 0, "variable", "`r`: a body, any of `row`", "r in row");
    ("sees", 0, "check", "check `sees`", "sees");
    ("steady", 0, "setting", "`steady`: movement steps keep the beat: no collision ends one", "");
    ("free_body", 0, "setting", "`free_body`: a turning body keeps its angular momentum", "");
    ("behaviour Open", 3, "keyword", "", "");
    ("possibly", 0, "keyword", "", "");
    ("distance2", 0, "quantity", "`distance2`: the squared distance of the centroids of two bodies", "");
    ("x(p)", 0, "quantity", "`x`: the x coordinate of the body's centroid", "");
    ("vx, vy", 0, "quantity", "`vx`: the process's own velocity along x", "");
    ("dt)", 0, "quantity", "`dt`: the time since the last update of this law", "");
    ("bonds(", 0, "quantity", "", "");
    ("offers", 0, "predicate", "", "");
    ("hit(", 0, "event", "", "");
    ("max(", 0, "function", "`max`: the greatest of some numbers", "");
    ("momentum", 0, "quantity", "", "");
    ("momentum.z", 9, "component", "`z`: along the z axis", "");
  ]

let kinds () =
  let check (piece, within, kind, line, declared) =
    let offset = place model piece + within in
    let d = told model offset in
    check_text ("kind in " ^ piece) kind d.kind;
    if line <> "" then check_text ("text in " ^ piece) line (first_line d.text);
    let at = if declared = "" then None else Some (place model declared) in
    Alcotest.(check (option int))
      ("declared, in " ^ piece) at
      (Option.map (fun (s : Span.t) -> s.start) d.declared)
  in
  List.iter check by_hand

let texts () =
  let at piece within = (told model (place model piece + within)).text in
  check_text "the declaration" "value `far`\nlet far = 2*speed" (at "mass far" 5);
  check_text "a quantifier" "`r`: a body, any of `row`\nforall r in row" (at "r) <=" 0);
  check_text "a channel"
    "channel `dock`\nopen as `dock` once in Open\nin bonds from the start once in q\nasked about once in meets"
    (at "dock, {right" 0);
  check_text "a channel that is passed on" "channel `arm`\nas an argument once in Open\nasked about once in sees"
    (at "Key(arm" 4);
  check_text "a word"
    "`possibly`: some run reaches an instant at which this holds (EF)\n(specs/language.md, Properties)"
    (at "possibly" 0);
  check_text "a module" "the module of the file \"parts.sc\"\nit declares width, Tile(a), Sticky" (at "t.Tile" 0);
  check_text "of a module"
    "shape `Tile(a)`: box(a, a, width), from \"parts.sc\"\nshape Tile(a) = box(a, a, width)" (at "t.Tile" 2);
  Alcotest.(check bool) "a long declaration" true (String.length (at "Cube scaled" 0) < 450);
  let nowhere = told "import \"gone.sc\" as g process p = g.Tile [nil]" 36 in
  check_text "a file that is not there" "`Tile` of \"gone.sc\"" nowhere.text

let places () =
  let text = "process  pq = Cube [nil] // pq\n" in
  let name offset = name_of (find text offset) in
  let check offset expected = Alcotest.(check (option string)) (string_of_int offset) expected (name offset) in
  check 0 (Some "process");
  check 7 (Some "process");
  check 8 None;
  check 9 (Some "pq");
  check 11 (Some "pq");
  check 12 None;
  check 24 None;
  check 29 None;
  check (String.length text) None;
  Alcotest.(check (option string)) "at the end" (Some "model") (name_of (find "model" 5));
  let bar = "behaviour K = <\xc4\x81, {f}>. \xcf\x89(a, {f}). nil" in
  check_text "a co-name" "channel" (told bar (place bar "\xc4\x81")).kind;
  check_text "omega" "omega" (told bar (place bar "\xcf\x89")).name

let is_name (t : Tokens.token) = match t.token with NAME _ | BARRED _ | LETTER _ -> true | _ -> false

(* How often names are used, their declarations among them. *)
let uses () =
  let tokens = Tokens.read (Source.make ~name:"m.sc" model) in
  let find = find model in
  let counts = Hashtbl.create 16 in
  let count (t : Tokens.token) =
    match find t.start with
    | Some ({ declared = Some at; _ } : Describe.t) when at.stop <= String.length model ->
      let key = (String.sub model at.start (at.stop - at.start), at.start) in
      Hashtbl.replace counts key (1 + Option.value ~default:0 (Hashtbl.find_opt counts key))
    | Some _ | None -> ()
  in
  Array.iter (fun (t : Tokens.token) -> if is_name t then count t) tokens.tokens;
  let check (name, declared, expected) =
    let key = (name, place model declared) in
    Alcotest.(check int) name expected (Option.value ~default:0 (Hashtbl.find_opt counts key))
  in
  List.iter check
    [
      ("speed", "speed = 3", 3); ("early", "early in", 3); ("far", "far = 2", 3); ("Cube", "Cube {", 6);
      ("Long", "Long = Cube", 3); ("Pair", "Pair {", 2); ("one", "one : Cube", 3); ("two", "two : Cube", 2);
      ("Open", "Open on", 2); ("Key", "Key(ch", 2); ("ch", "ch, side) =", 3); ("side", "side) =", 3);
      ("late", "late = early", 2); ("Wait", "Wait[i] =", 3); ("p", "p = Cube", 5); ("q", "q = u", 2);
      ("u", "u : Cube", 2); ("v", "v : Long", 2); ("row", "row[k]", 2); ("k", "k in 1", 5); ("r", "r in row", 2);
      ("wall", "wall = Pair", 2); ("right", "right [b", 4); ("left", "left [a", 4); ("a", "a (-1", 4);
    ]

(* {1 Texts full of faults} *)

let broken = {|model broken
param speed = 1 +
shape Cube { vertices a (0,0,0) b (1,0,0) c (0,1,0) d (0,0,1)  faces f [a,c,b] }
behaviour P on Cube = <k, {f}>. P
behaviour Q on Cube = <~k {f}>. Q
for i in 1..4 {
  process c[i] = Cube mass 1 [P]
  let s = 3 *
  process d[i] = Cube mass s velocity (speed, 0, 0) [Q]
}
process q = Cube mass 2 [Q
fixed wall = Cube at translate (12, 0, 0) }
check meet : possibly touching(q, wall
check fine : always distance2(c, wall) > 0 and colour
|}

let faults () =
  let check (piece, within, kind, line) =
    let d = told broken (place broken piece + within) in
    check_text ("kind in " ^ piece) kind d.kind;
    check_text ("text in " ^ piece) line (first_line d.text)
  in
  let unread kind name = Printf.sprintf "%s `%s`, of which the declaration cannot be read yet" kind name in
  List.iter check
    [
      ("[P]", 1, "behaviour", "behaviour `P`, for `Cube`");
      ("k {f", 0, "channel", "channel `k`");
      ("k {f", 3, "face", "face `f` of `Cube`, with the corners a, c, b");
      ("speed, 0", 0, "parameter", unread "parameter" "speed");
      ("mass s", 5, "value", unread "value" "s");
      ("c[i]", 2, "index", unread "index" "i");
      ("c[i]", 0, "process", "process `c[i]`: Cube, mass 1, behaves as P");
      ("[Q]", 1, "behaviour", unread "behaviour" "Q");
      ("(q", 1, "process", unread "process" "q");
      ("(q, wall", 4, "fixed", "fixed body `wall`: Cube");
      ("touching", 0, "predicate", "`touching`: the two bodies touch, be they bound or not");
      ("(c, wall", 1, "process", "process `c[i]`: Cube, mass 1, behaves as P");
      ("colour", 0, "name", "`colour`: there is no declaration of this name");
    ];
  let qualified = "import <solids> process p = solids.Cube(2) [<a, {left}>. nil" in
  check_text "of a module" "shape `Cube(a)`: box(a, a, a), from <solids>"
    (first_line (told qualified (place qualified "Cube")).text);
  Alcotest.(check (option string)) "no text" None (name_of (find "p\x00 = \xff" 0));
  let deep = String.concat "" (List.init 3000 (fun _ -> "(")) in
  Alcotest.(check bool) "too deep" true (Option.is_some (find ("check c : " ^ deep) 0))

let readable () =
  let items text = List.length (Parse.readable (Source.make ~name:"m.sc" text)) in
  Alcotest.(check int) "of a text without faults" 22 (items model);
  Alcotest.(check int) "of one with many" 7 (items broken);
  Alcotest.(check int) "of none" 0 (items "");
  Alcotest.(check int) "of no text" 0 (items "model x \x00");
  Alcotest.(check int) "a loop is whole, or looked into" 2 (items "for i in 1..2 { let x = let y = 2 model m }")

(* What leads back to itself, in several ways, is looked into once. *)
let circles () =
  let doubled =
    {|shape A = A scaled (2,2,2)
shape A = A scaled (3,3,3)
behaviour F(x) = eps(1). F(x) + eps(2). F(x) + eps(3). F(x) + eps(4). F(x) + eps(5). F(x) + eps(6). F(x)
               + eps(7). F(x) + eps(8). F(x)
behaviour G on A = <a, {left}>. F(b)
|}
  in
  let since = Sys.time () in
  let find = find doubled in
  let kind piece = Option.map (fun (d : Describe.t) -> d.kind) (find (place doubled piece)) in
  Alcotest.(check (option string)) "of an image of itself" (Some "feature") (kind "left");
  Alcotest.(check (option string)) "passed on for ever" (Some "feature") (kind "b)");
  Alcotest.(check bool) "at once" true (Sys.time () -. since < 1.)

(* {1 The vocabulary} *)

let section_of_reference = "../../../specs/language.md"

let vocabulary () =
  let all category words =
    let told (e : Vocabulary.entry) = if e.category = category then Some e.word else None in
    let found = List.sort String.compare (List.filter_map told Vocabulary.all) in
    Alcotest.(check (list string)) "all words, each once" (List.sort_uniq String.compare words) found
  in
  all Word (List.map fst Lexer.words);
  all Atom Scc_elaborate.Atoms.words;
  all Event Scc_elaborate.Atoms.transitions;
  all Measure Scc_elaborate.Measures.words;
  all Law Scc_elaborate.Laws.(functions @ words);
  all Function ("round" :: Scc_elaborate.Operations.functions);
  let lines = String.split_on_char '\n' (read section_of_reference) in
  let check (e : Vocabulary.entry) =
    Alcotest.(check bool) ("the section of " ^ e.word) true (List.mem ("## " ^ e.section) lines);
    Alcotest.(check bool) ("a line: " ^ e.word) false (String.contains e.meaning '\n')
  in
  List.iter check Vocabulary.all

(* {1 Every model} *)

let folder = "../../../specs/models/"

let models =
  let of_folder name =
    let files = List.sort String.compare (Array.to_list (Sys.readdir (folder ^ name))) in
    List.filter_map (fun f -> if Filename.check_suffix f ".sc" then Some (name ^ f) else None) files
  in
  of_folder "" @ of_folder "laws/"

(* At every byte there is an answer or none; every name is told, and where it is declared it is itself declared. *)
let every_byte file =
  let text = read (folder ^ file) in
  let modules ~library name =
    if library then Scc_elaborate.Library.find name
    else match read (folder ^ name) with text -> Some text | exception Sys_error _ -> None
  in
  let find = Describe.find ~read_module:modules (Source.make ~name:file text) in
  let all = Array.init (String.length text + 1) find in
  let fail (d : Describe.t) what = Alcotest.failf "%s: `%s` at %d: %s" file d.name d.at.start what in
  let tokens = Tokens.read (Source.make ~name:file text) in
  let check (t : Tokens.token) =
    for i = t.start to t.stop - 1 do
      match all.(i) with
      | None -> Alcotest.failf "%s: nothing is told at %d" file i
      | Some d ->
        if d.at.start <> t.start || d.at.stop <> t.stop then fail d "another place";
        if d.kind = "name" then fail d "it is not known"
    done
  in
  let declared (d : Describe.t) =
    match d.declared with
    | None -> ()
    | Some at -> (
        match all.(at.start) with
        | Some e when Option.fold ~none:false ~some:(Span.equal at) e.declared -> ()
        | Some _ | None -> fail d "its declaration is not one")
  in
  Array.iter (fun t -> if is_name t then check t) tokens.tokens;
  Array.iter (Option.iter declared) all;
  (* cut off anywhere, there are no exceptions *)
  let length = String.length text in
  List.iter
    (fun k ->
       let cut = String.sub text 0 (k * length / 8) in
       let find = Describe.find ~read_module:modules (Source.make ~name:file cut) in
       for i = 0 to String.length cut do ignore (find i) done)
    [ 3; 7 ]

let () =
  Alcotest.run "describe"
    [
      ( "by hand",
        [ case "kinds" kinds; case "texts" texts; case "places" places; case "uses" uses ] );
      ("faults", [ case "names" faults; case "readable" readable; case "circles" circles ]);
      ("vocabulary", [ case "words" vocabulary ]);
      ("models", List.map (fun file -> case file (fun () -> every_byte file)) models);
    ]
