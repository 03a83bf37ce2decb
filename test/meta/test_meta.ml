(* The rule book, the list of deviations, the cases and the code must not drift apart. *)

let rulebook = "specs/rulebook.md"
let deviations = "specs/deviations.md"
let entries path = Book.entries (Tree.read path)

(* Every failure is worth seeing at once. *)
let none what faults = if faults <> [] then Alcotest.failf "%s:\n%s" what (String.concat "\n" faults)

let faults_of path fault_of () =
  let entries = entries path in
  Alcotest.(check bool) (path ^ " has entries") true (entries <> []);
  let tell (e : Book.entry) why = Printf.sprintf "%s:%d: %s: %s" path e.line e.id why in
  none path (List.concat_map (fun e -> List.map (tell e) (fault_of e)) entries)

(* {1 Entries} *)

let defines text name =
  List.exists
    (fun keyword -> List.exists (String.equal name) (Tree.words_after (keyword ^ " ") text))
    [ "let"; "rec"; "and" ]

let code_faults (e : Book.entry) =
  List.filter_map
    (fun (file, name) ->
       if not (Tree.exists file) then Some ("no file " ^ file)
       else if defines (Tree.read file) name then None
       else Some (Printf.sprintf "%s does not define %s" file name))
    e.code

let test_faults (e : Book.entry) =
  List.filter_map
    (fun (file, name) ->
       if not (Tree.exists file) then Some ("no file " ^ file)
       else if Tree.contains (Tree.read file) name then None
       else Some (Printf.sprintf "%s has no case \"%s\"" file name))
    e.tests

let model_faults (e : Book.entry) =
  List.filter_map (fun path -> if Tree.exists path then None else Some ("no model " ^ path)) e.models

let malformed (e : Book.entry) = List.map (fun line -> "cannot be read: " ^ line) e.malformed
let missing what list = if list = [] then [ "no " ^ what ] else []


(* The laws are what follows of the rules: no code of their own, but a test that bears the name of the law. *)
let is_law (e : Book.entry) = String.equal e.chapter "Laws"

(* What is done to files before there is a model: no question of the suite's is about it. *)
let is_around (e : Book.entry) = String.equal e.chapter "Around the calculus"
let is_named_after (e : Book.entry) test = Tree.starts_with (e.id ^ ": ") test

let law_complete (e : Book.entry) =
  let named = List.filter (fun (_, test) -> is_named_after e test) e.tests in
  missing (Printf.sprintf "test whose name begins with \"%s: \"" e.id) named @ malformed e

let rule_complete (e : Book.entry) =
  missing "code" e.code @ missing "test" e.tests @ missing "model" e.models @ malformed e

let entry_complete e = if is_law e then law_complete e else rule_complete e

let deviation_complete (e : Book.entry) = missing "test" e.tests @ malformed e

let distinct path () =
  let ids = List.map (fun (e : Book.entry) -> e.id) (entries path) in
  let repeated = List.filter (fun id -> List.length (List.filter (String.equal id) ids) > 1) ids in
  none "repeated ids" (List.sort_uniq String.compare repeated)

(* {1 From the code back to the book} *)

let ids_of entries = List.map (fun (e : Book.entry) -> e.id) entries
let known = lazy (ids_of (entries rulebook))
let is_known id = List.exists (String.equal id) (Lazy.force known)
let rules = lazy (ids_of (List.filter (fun e -> not (is_law e)) (entries rulebook)))
let laws = lazy (List.filter is_law (entries rulebook))

let every_rule () =
  List.map Scc_semantics.Rule.id Scc_semantics.Rule.all
  |> List.filter (fun id -> not (is_known id))
  |> none "rules of the code without an entry"

(* A capital after "rule": the name of one. "Rule" itself also names a module. *)
let cited_rules text =
  Tree.words_after "rule " text @ Tree.words_after "Rule " text
  |> List.filter (fun w -> w <> "" && w.[0] >= 'A' && w.[0] <= 'Z')

(* "law" before a capital: the name of one. *)
let cited_laws text =
  Tree.words_after "law " text |> List.filter (fun w -> w <> "" && w.[0] >= 'A' && w.[0] <= 'Z')

let cited_definitions text =
  Tree.words_after "Definition " text
  |> List.filter (fun w -> w <> "" && w.[0] >= '0' && w.[0] <= '9')
  |> List.map (fun w -> "Def-" ^ w)

let cited_readings text =
  List.filter_map
    (fun w -> if w <> "" && w.[0] >= '0' && w.[0] <= '9' then Some ("I-" ^ w) else None)
    (Tree.words_after "I-" text)

let citations () =
  Tree.files "lib" @ Tree.files "specs"
  |> List.filter (fun f ->
      List.exists (Filename.check_suffix f) [ ".ml"; ".mli"; ".mly"; ".mll"; ".md"; ".sc" ])
  |> List.concat_map (fun file ->
      let text = Tree.read file in
      cited_rules text @ cited_laws text @ cited_definitions text @ cited_readings text
      |> List.filter (fun id -> not (is_known id))
      |> List.map (fun id -> Printf.sprintf "%s cites %s" file id))
  |> List.sort_uniq String.compare |> none "citations that lead nowhere"

let every_emission () =
  let entries = entries rulebook in
  let is_told (x : Emitted.t) =
    List.exists
      (fun (e : Book.entry) ->
         String.equal e.id x.rule && List.exists (fun (file, _) -> String.equal file x.file) e.code)
      entries
  in
  let found = Emitted.find () in
  Alcotest.(check bool) "some are found" true (List.length found > List.length Scc_semantics.Rule.all / 2);
  List.filter (fun (x : Emitted.t) -> not (is_told x)) found
  |> List.map (fun (x : Emitted.t) -> Printf.sprintf "%s:%d makes transitions by rule %s" x.file x.line x.rule)
  |> List.sort_uniq String.compare
  |> none "files that no Code line of their rule names"

(* {1 Readings} *)

let reading (e : Book.entry) =
  match String.split_on_char '-' e.id with
  | [ "I"; number ] -> int_of_string_opt number
  | _ -> None

(* Elsewhere they are cited, and told once, however many documents there are. *)
let readings () =
  let documents = List.filter (fun f -> Filename.check_suffix f ".md") (Tree.files "specs") in
  let headings file = List.filter_map reading (entries file) in
  let told = List.concat_map (fun file -> List.map (fun n -> (n, file)) (headings file)) documents in
  let last = List.fold_left (fun last (n, _) -> Int.max last n) 0 told in
  Alcotest.(check bool) "there are readings" true (last > 0);
  List.init last (fun i -> i + 1)
  |> List.filter_map (fun n ->
      match List.filter (fun (m, _) -> Int.equal m n) told with
      | [ (_, file) ] when String.equal file rulebook -> None
      | [] -> Some (Printf.sprintf "I-%d: nowhere" n)
      | places -> Some (Printf.sprintf "I-%d: %s" n (String.concat ", " (List.map snd places))))
  |> none "readings that are not in one place, the rule book"

(* {1 Laws} *)

(* What a test is called that bears the name of a law: all of these are on the lines of that law. *)
let tests_of_laws () =
  let laws = Lazy.force laws in
  Alcotest.(check bool) "there are laws" true (laws <> []);
  let cited (e : Book.entry) file test =
    List.exists (fun (f, name) -> String.equal f file && String.equal name test) e.tests
  in
  let faults_of file text (e : Book.entry) =
    Tree.quoted_after (e.id ^ ": ") text
    |> List.filter (fun test -> not (cited e file test))
    |> List.map (fun test -> Printf.sprintf "%s: \"%s\" is on no line of law %s" file test e.id)
  in
  Tree.files "test"
  |> List.filter (fun file -> Filename.check_suffix file ".ml" && not (Tree.starts_with "test/meta/" file))
  |> List.concat_map (fun file -> List.concat_map (faults_of file (Tree.read file)) laws)
  |> none "tests of laws that the book does not name"

(* {1 Cases} *)

let test_sources =
  lazy
    (Tree.files "test"
     |> List.filter (fun f ->
         Filename.check_suffix f ".ml" || Filename.check_suffix f ".t" || Filename.basename f = "dune")
     |> List.map Tree.read)

(* A case is run if a test names it, or names the folder whose files it takes all. *)
let is_run file =
  let named part = List.exists (fun text -> Tree.contains text part) (Lazy.force test_sources) in
  let rec folder_named path =
    let folder = Filename.dirname path in
    (not (List.mem folder [ "specs"; "specs/conformance"; "." ])) && (named folder || folder_named folder)
  in
  named (Filename.basename file) || folder_named file

let every_case () =
  Tree.files "specs/conformance" @ Tree.files "specs/models"
  |> List.filter (fun f -> not (is_run f))
  |> none "cases that no test runs"

(* By the name of a case that must be refused, or in what a test of the program expects. *)
let every_code () =
  let cases = Tree.files "specs/conformance/invalid" in
  let transcripts =
    List.filter (fun f -> Filename.check_suffix f ".t") (Tree.files "test/cli") |> List.map Tree.read
  in
  Scc_base.Code.all
  |> List.filter_map (fun (code, what) ->
      let code = (code : Scc_base.Code.t :> string) in
      let has text = Tree.contains text code in
      if List.exists has cases || List.exists has transcripts then None else Some (code ^ ": " ^ what))
  |> none "codes without a case in specs/conformance/invalid"

(* {1 The conformance suite} *)

let suite = lazy (Suite.read ())
let all_cases () = List.concat_map (fun (f : Suite.file) -> f.cases) (Lazy.force suite).files

(* As many as the manifest says, and each of them under a rule that the book has. *)
let suite_counts () =
  let suite = Lazy.force suite in
  let cases = all_cases () in
  Alcotest.(check bool) "at least 1 000 cases" true (List.length cases >= 1000);
  Alcotest.(check int) "cases in all" suite.cases (List.length cases);
  List.iter (fun (f : Suite.file) -> Alcotest.(check int) f.path f.count (List.length f.cases)) suite.files;
  let ids = List.map (fun (c : Suite.case) -> c.id) cases in
  Alcotest.(check int) "distinct ids" (List.length ids) (List.length (List.sort_uniq String.compare ids));
  List.concat_map (fun (c : Suite.case) -> c.rules) cases
  |> List.sort_uniq String.compare
  |> List.filter (fun id -> not (is_known id))
  |> none "rules of cases without an entry"

(* Every definition, rule and reading has a file of its own, by hand, and is counted rightly. *)
let suite_rules () =
  let suite = Lazy.force suite in
  let count id = List.length (List.filter (fun (c : Suite.case) -> List.mem id c.rules) (all_cases ())) in
  let fault id =
    match List.assoc_opt id suite.rules with
    | None -> Some (id ^ ": not in the manifest")
    | Some (n, _) when n <> count id -> Some (Printf.sprintf "%s: %d cases, not %d" id (count id) n)
    | Some (_, files) when not (List.mem (Printf.sprintf "rules/%s/cases.json" id) files) ->
      Some (id ^ ": no cases by hand")
    | Some _ -> None
  in
  let around = ids_of (List.filter is_around (entries rulebook)) in
  List.filter (fun id -> not (List.mem id around)) (Lazy.force rules)
  |> List.filter_map fault |> none "rules without cases in specs/conformance"

let suite_codes () =
  let suite = Lazy.force suite in
  let ids = List.map (fun (c : Suite.case) -> c.id) (all_cases ()) in
  let fault (code, what) =
    let code = (code : Scc_base.Code.t :> string) in
    match List.assoc_opt code suite.diagnostics with
    | None | Some ([], []) -> Some (code ^ ": " ^ what)
    | Some (cases, commands) ->
      let lost =
        List.filter (fun id -> not (List.mem id ids)) cases
        @ List.filter (fun c -> not (Tree.exists ("specs/conformance/" ^ c))) commands
      in
      if lost = [] then None else Some (code ^ ": no such case: " ^ String.concat ", " lost)
  in
  List.filter_map fault Scc_base.Code.all |> none "codes without a case in specs/conformance/manifest.json"

(* No value is that of scc alone. *)
let suite_obtained () =
  all_cases ()
  |> List.filter (fun (c : Suite.case) ->
      not (Tree.contains c.obtained "by hand" || Tree.contains c.obtained "test/"))
  |> List.map (fun (c : Suite.case) -> c.id ^ ": " ^ c.obtained)
  |> none "cases that do not say how their values were obtained"

(* {1 Links} *)

let links () =
  let documents =
    [ "README.md"; "CHANGES.md"; "CONTRIBUTING.md"; "DEVEL.md" ]
    @ List.concat_map Tree.files [ "clients"; "editors"; "lib"; "scripts"; "specs"; "test" ]
    |> List.filter (fun file -> Filename.check_suffix file ".md")
  in
  Alcotest.(check bool) "documents are found" true (List.length documents > 15);
  List.concat_map Links.faults documents |> none "links that lead nowhere"

(* {1 Version} *)

let version () =
  match Tree.words_after "(version " (Tree.read "dune-project") with
  | version :: _ ->
    let says (file, text) =
      if Tree.contains (Tree.read file) (text ^ version) then None
      else Some (Printf.sprintf "%s: %s%s" file text version)
    in
    List.filter_map says
      [
        ("clients/python/pyproject.toml", "\nversion = \"");
        ("clients/python/src/shapecalculus/__init__.py", "__version__ = \"");
        ("CHANGES.md", "\n## ");
      ]
    |> none "texts that lack the version of dune-project"
  | [] -> Alcotest.fail "no version in dune-project"

(* {1 Wings} *)

let wings () =
  Alcotest.(check int) "wings" 9 (List.length (Wings.all ()));
  let folders = List.filter_map (fun file -> List.nth_opt (String.split_on_char '/' file) 1) (Tree.files "lib") in
  List.sort_uniq String.compare folders
  |> List.filter (fun name -> not (List.mem name ("dune" :: "index.mld" :: Wings.all ())))
  |> none "folders of lib/ that are no wing of DEVEL.md"

(* What only runs models builds and starts without what verifies them. *)
let runs () =
  let from = [ "scc_runs"; "scc_export"; "scc_simulate"; "scc_conform" ] in
  none "edges from what runs models to what verifies them" (Wings.reaches ~from ~wing:"verification")

let in_each_wing faults what () = List.concat_map faults (Wings.all ()) |> none what

let () =
  let case name f = Alcotest.test_case name `Quick f in
  Alcotest.run "meta"
    [
      ( "rule book",
        [
          case "every entry is complete" (faults_of rulebook entry_complete);
          case "ids are distinct" (distinct rulebook);
          case "code lines lead to functions" (faults_of rulebook code_faults);
          case "test lines lead to cases" (faults_of rulebook test_faults);
          case "model lines lead to models" (faults_of rulebook model_faults);
          case "every rule of the code has an entry" every_rule;
          case "every citation leads to an entry" citations;
          case "what makes transitions by a rule is on its code lines" every_emission;
          case "every reading is in one place" readings;
          case "every test of a law is on its lines" tests_of_laws;
        ] );
      ( "deviations",
        [
          case "every entry is complete" (faults_of deviations deviation_complete);
          case "ids are distinct" (distinct deviations);
          case "test lines lead to cases" (faults_of deviations test_faults);
        ] );
      ( "cases",
        [
          case "every case is run by a test" every_case;
          case "every code has a case" every_code;
        ] );
      ( "conformance suite",
        [
          case "its cases are those of the manifest" suite_counts;
          case "every rule and reading has cases" suite_rules;
          case "every code has one" suite_codes;
          case "every case says how it was obtained" suite_obtained;
        ] );
      ( "wings",
        [
          case "there are nine" wings;
          case "no edge leads upward" (in_each_wing Wings.upward "edges to wings that may not be used");
          case "wings are ordered" (fun () -> none "wings that may use a later one" (Wings.unordered ()));
          case "every edge is used" (in_each_wing Wings.unused "edges that no source needs");
          case "runs need no verification" runs;
          case "every room is named" (in_each_wing Wings.unnamed "rooms and READMEs that disagree");
          case "every file that a README names is there" (in_each_wing Wings.misplaced "files that are not there");
          case "a README is a page" (in_each_wing Wings.too_long "READMEs of more than 60 lines");
        ] );
      ( "certificate",
        [
          case "shares the kernel, polyhedra and predicates alone" (fun () ->
              none "libraries that the check of invariants may not use" (Certificate.strangers ()));
          case "the search takes from it what an invariant is" (fun () ->
              none "what the search uses of the check" (Certificate.borrowed ()));
        ] );
      ( "kernel",
        [
          case "no mutation, floats or search" (fun () -> none "what the kernel does not do" (Kernel.impure ()));
          case "its reading list is whole" (fun () -> none "modules that are not listed" (Kernel.unlisted ()));
        ] );
      ( "program",
        [
          case "top-level state is listed" (fun () ->
              none "state and its list disagree" (Parsed.unlisted_state ()));
          case "no function is long" (fun () -> none "functions that are too long" (Parsed.longest ~most:60));
        ] );
      ( "files",
        [
          case "only sources, whatever comes and goes" Walked.sources_only;
        ] );
      ( "documents",
        [
          case "every link leads somewhere" links; case "the version is that of dune-project" version;
        ] );
    ]
