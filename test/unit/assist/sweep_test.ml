(* Sweeps: names that are spelt wrongly in each place, and what is offered in each place. *)

open Scc_base
open Scc_syntax
open Scc_describe
open Scc_assist
open Texts

(* The family's name alone is replaced, in each place where a body is named, and each family is offered once. *)
let families () =
  let declared =
    "for i in 1..3 { process clast[i] = box(1,1,1) mass 1 at translate (9*i, 0, 0) [nil] }\n\
     for i in 1..3 { process blqast[i] = box(1,1,1) mass 1 at translate (9*i, 20, 0) [nil] }\n"
  in
  let one (before, after) =
    let text name = declared ^ before ^ name ^ after in
    let found = Fixes.of_diagnostics (reading (text "blast")) (load (text "blast")) in
    let edits (_, (f : Fixes.t)) = Rename.apply (text "blast") f.edits in
    texts (before ^ after) [ text "blqast" ] (List.map edits found)
  in
  List.iter one
    [
      ("for i in 1..3 { motion ", "[i] = (1,0,0) }\n");
      ("for i in 1..2 { bond <a, {", "[i].right, clast[i+1].left}> }\n");
      ("bond <a, {", "[2].[b, c], clast[1].left}>\n");
      ("network ", "[1] || clast[2]\n");
      ("check c : always forall i in 1..3: x(", "[i]) > 0\n");
      ("check c : always bound(", "[1], clast[2])\n");
      ("check c : always count(b in ", " : x(b) > 0) = 3\n");
    ];
  let other = declared ^ "check c : always x(clast[4]) > 0\n" in
  Alcotest.(check int) "another member is no fix" 0
    (List.length (Fixes.of_diagnostics (reading other) (load other)))

(* Each name that an import brings, with a letter less or one more, by each way to import. *)
let imported () =
  let count = ref 0 in
  let exported = [ ("<solids>", Option.get (Scc_elaborate.Library.find "solids")); ("\"parts.sc\"", parts) ] in
  let names text = List.filter_map (fun (i : Ast.item) ->
      match i.it with
      | Shape (h, _, _) | Compound (h, _, _, _) ->
        let arguments = List.map (fun _ -> "1") h.formals in
        Some (h.declared.it, if arguments = [] then "" else "(" ^ String.concat "," arguments ^ ")")
      | _ -> None)
      (Result.get_ok (Scc_notation.Notation.model (Source.make ~name:"m.sc" text)))
  in
  let one import qualifier (name, arguments) =
    let text name =
      Printf.sprintf "import %s\nprocess p = %s%s%s mass 1 [nil]\n" (import name) qualifier name arguments
    in
    let wrong name = [ String.sub name 0 (String.length name - 1); name ^ "x" ] in
    let mended w =
      incr count;
      match Fixes.of_diagnostics (reading (text w)) (load (text w)) with
      | (_, f) :: _ -> Alcotest.(check string) (text w) (text name) (Rename.apply (text w) f.edits)
      | [] -> Alcotest.failf "nothing mends %s" (text w)
    in
    let is_clear w = String.length w > 2 in
    List.iter mended (List.filter is_clear (wrong name))
  in
  let of_module (file, text) =
    let base = if file = "<solids>" then "solids." else "parts." in
    let ways = [ ((fun _ -> file), base); ((fun _ -> file ^ " as m"), "m.") ] in
    List.iter (fun (import, q) -> List.iter (one import q) (names text)) ways
  in
  List.iter of_module exported;
  Alcotest.(check bool) (Printf.sprintf "%d names" !count) true (!count > 40)

(* Predefined names are of no module, whatever stands before. *)
let of_no_module () =
  let before =
    "import <solids>\nimport \"tiles.sc\"\nfixed a = box(3,1,1)\nfixed b = prism(3,1,1) at translate (9,0,0)\n\
     fixed c = antiprism(3,1,1) at translate (18,0,0)\nfixed d = pyramid(3,1,1) at translate (27,0,0)\n\
     fixed e = solids.Cube(1) at translate (36,0,0)\nfixed f = tiles.Tile(1) at translate (45,0,0)\n"
  in
  let holds text = List.exists Diag.is_error (load text) in
  Alcotest.(check bool) "without it there is no error" false (holds before);
  let one (e : Vocabulary.entry) =
    let refused text =
      if not (holds text) then Alcotest.failf "%s is accepted" text
    in
    let use m =
      refused (Printf.sprintf "%sprocess p = %s.%s(3,1,1) at translate (0,9,0) [nil]\n" before m e.word);
      refused (Printf.sprintf "%sprocess p = %s.%s(3,1,1) at translate (0,9,0) [nil]\n%s" "" m e.word before);
      refused (Printf.sprintf "%slet v = %s.%s(3,1)\nfixed p = box(v,v,v) at translate (0,9,0)" before m e.word);
      refused (Printf.sprintf "%slet v = %s.%s\nfixed p = box(v,v,v) at translate (0,9,0)" before m e.word)
    in
    List.iter use [ "solids"; "tiles" ]
  in
  List.iter one Vocabulary.all;
  let offered = names (before ^ "process p = solids.") in
  List.iter (fun n -> if List.mem n offered then Alcotest.failf "%s is offered" n) [ "box"; "prism"; "pyramid" ]

(* {1 What is offered fits} *)

(* Where a name stands as an argument in a check, or begins a behaviour of a process, each name that is offered is
   put in its place: then there is no error there about an unknown name or one of another kind. What is offered
   with indices or arguments needs them. *)
let is_whole (o : Completion.offer) =
  let needs form = String.contains form '[' || String.contains form '(' in
  List.mem o.kind [ "body"; "channel"; "behaviour"; "shape"; "value"; "feature" ]
  && not (Option.fold ~none:false ~some:needs o.form)

(* The items that contain an offset, from the outermost. *)
let rec around at (items : Ast.model) =
  let within (i : Ast.item) = i.at.start <= at && at < i.at.stop in
  match List.find_opt within items with
  | Some ({ it = For (_, inner); _ } as i) -> i.it :: around at inner
  | Some i -> [ i.it ]
  | None -> []

let fitting () =
  let places = ref 0 and offered = ref 0 in
  let model folder (file, text) =
    let read_file path = try Ok (read (Filename.concat folder path)) with Sys_error e -> Error e in
    let faults text =
      let source = Source.make ~name:file text in
      match Scc_loading.Loaded.load ~read_file ~overrides:[] source with Ok _ -> [] | Error found -> found
    in
    let r = reading text in
    let known = Known.of_text modules r and tokens = (Lazy.force r.tokens).tokens in
    let put (t : Tokens.token) (o : Completion.offer) =
      incr offered;
      let changed = Rename.apply text [ (Span.make ~file ~start:t.start ~stop:t.stop, o.name) ] in
      let wrong (d : Diag.t) =
        List.mem d.code [ "SC0201"; "SC0210" ] && d.span.start <= t.start && t.start <= d.span.stop
      in
      match List.find_opt wrong (faults changed) with
      | Some d ->
        let stood = String.sub text t.start (t.stop - t.start) in
        Alcotest.failf "%s: `%s` for %s: %s" file o.name stood d.message
      | None -> ()
    in
    let in_check at = List.exists (function Ast.Check _ -> true | _ -> false) (around at (Lazy.force r.model)) in
    let in_process at =
      List.exists (function Ast.Process _ -> true | _ -> false) (around at (Lazy.force r.model))
    in
    let is_place i =
      let t = tokens.(i) in
      (match tokens.(i + 1).token with COMMA | RPAREN | RBRACKET -> true | _ -> false)
      &&
      match (tokens.(i - 1).token, t.token) with
      | (LPAREN | COMMA), (NAME _ | LETTER _) -> in_check t.start
      | LBRACKET, (NAME _ | LETTER _) -> 
        let is_index = match tokens.(i + 2).token with COLON | DOT -> true | _ -> false in
        in_process t.start && i > 2 && tokens.(i - 3).token <> PROCESS && not is_index
      | _ -> false
    in
    for i = 1 to Array.length tokens - 2 do
      if is_place i then begin
        incr places;
        let all = snd (Completion.at known text tokens.(i).start) in
        List.iter (put tokens.(i)) (List.filter is_whole all)
      end
    done
  in
  let all folder = List.iter (model folder) (models folder) in
  all "../../../specs/cookbook";
  let counts = Printf.sprintf "%d names at %d places" !offered !places in
  Alcotest.(check bool) counts true (!places > 40 && !offered > 40)

(* What is called in a formula, without brackets: the hint tells that they are missing. *)
let without_brackets () =
  let count = ref 0 in
  let one (e : Vocabulary.entry) =
    let called = match Forms.find Called e.word with Some (f :: _) -> String.contains f '(' | _ -> false in
    if called && (e.category = Atom || e.category = Function) && not (Tokens.is_word e.word) then begin
      let text = Printf.sprintf "process p = box(1,1,1) mass 1 [nil]\ncheck c : always %s > 0\n" e.word in
      let hints =
        [
          Printf.sprintf "say of which process: `%s(p)`" e.word;
          Printf.sprintf "say of which processes: `%s(p, q)`" e.word;
          Printf.sprintf "its arguments stand in brackets after it: `%s(...)`" e.word;
        ]
      in
      incr count;
      let is_told (d : Diag.t) = List.exists (fun hint -> d.hint = Some hint) hints in
      if not (List.exists is_told (load text)) then Alcotest.failf "no hint: %s" e.word
    end
  in
  List.iter one Vocabulary.all;
  Alcotest.(check bool) (Printf.sprintf "%d words" !count) true (!count > 15)

(* {1 The word that is being written} *)

(* Each prefix of a text, and the whole text at the same place, ends within a name that is being written. If that
   name is offered, then it stands elsewhere, or is offered as well for the text without it: it comes from
   elsewhere. *)
let half_written () =
  let places = ref 0 and wrong = ref [] in
  let known text = Known.of_text modules (reading text) in
  let is_letter c = match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | _ -> false in
  let stands word text =
    let is_it (t : Tokens.token) = 
      match t.token with
      | BARRED n -> String.equal n word
      | _ -> String.equal (String.sub text t.start (t.stop - t.start)) word
    in
    Array.exists is_it (Lazy.force (reading text).tokens).tokens
  in
  let at file text offset rest =
    let from, found = Completion.at (known text) text offset in
    let word = String.sub text from (offset - from) ^ rest in
    let is_it (o : Completion.offer) = String.equal o.name word in
    incr places;
    if word <> "" && List.exists is_it found then begin
      let stop = offset + String.length rest in
      let without = String.sub text 0 from ^ String.sub text stop (String.length text - stop) in
      let is_offered () = List.exists is_it (snd (Completion.at (known without) without from)) in
      if not (stands word without || is_offered ()) then
        wrong := Printf.sprintf "%s:%d: %s (%s)" file offset word (List.find is_it found).kind :: !wrong
    end
  in
  let rec word_ends text k = if k < String.length text && is_letter text.[k] then word_ends text (k + 1) else k in
  let every = match Sys.getenv_opt "SCC_TIMES" with Some n -> Int.max 1 (60 / int_of_string n) | None -> 151 in
  let k = ref 0 in
  let model (file, text) =
    for offset = 1 to String.length text do
      if is_letter text.[offset - 1] then begin
        incr k;
        if !k mod every = 0 then begin
          at file (String.sub text 0 offset) offset "";
          at file text offset (String.sub text offset (word_ends text offset - offset))
        end
      end
    done
  in
  List.iter model (all_models () @ models "../../../specs/cookbook");
  texts (Printf.sprintf "%d places" !places) [] (List.rev !wrong);
  Alcotest.(check bool) (Printf.sprintf "%d places" !places) true (!places > 800)

let one = "shape A { vertices p (0,0,0) faces f [p] }\nprocess one = A mass 1 [<~ink, {f}>. nil]\n"

let named known text =
  List.map (fun (o : Completion.offer) -> o.name) (snd (Completion.at known text (String.length text)))

let just (text, wanted) =
  let text = one ^ text in
  texts text wanted (named (Known.of_text modules (reading text)) text)

let by_hand () =
  List.iter just
    [
      ("process two = A mass 1 [<inx", []);
      ("process two = A mass 1 [<in", [ "ink" ]);
      ("process two = A mass 1 [<ink", [ "ink" ]);
      ("// inkpot\n/* inkpot /* inkpot */ */process two = A mass 1 [<inkp", []);
      ("process two = A mass 1 [<ā, {f}>. <", [ "ink"; "a" ]);
      ("process two = A mass 1 [<floor", []);
      ("check c : bound(one, tw", []);
    ];
  (* known of the text as it was a moment ago *)
  let text word = one ^ "process two = A mass 1 [<" ^ word in
  let known = Known.of_text modules (reading (text "inkpot")) in
  texts "one letter less" [] (named known (text "inkpo"));
  texts "what is left" [ "ink" ] (named known (text "in"))

let () =
  Alcotest.run "sweeps of names"
    [
      ( "fixes",
        [
          case "families" families; case "imported names" imported;
          case "predefined names are of no module" of_no_module;
          case "calls without brackets" without_brackets;
        ] );
      ("what is offered fits", [ case "in the cookbook" fitting ]);
      ("what is offered stands elsewhere", [ case "by hand" by_hand; case "in all prefixes" half_written ]);
    ]
