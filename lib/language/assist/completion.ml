open Scc_describe
open Offers

type offer = Offers.offer = { name : string; kind : string; form : string option; about : string option }

(* {1 What fits} *)

(* Words of declarations, which no formula has. *)
let declaring =
  List.filter (fun word -> not (List.mem word [ "bonds"; "for"; "at" ])) (List.append beginning attributes)

let formula t =
  bodies t @ values t
  @ entries Vocabulary.Atom Forms.Called
  @ entries Vocabulary.Function Forms.Called
  @ names "channel" (channels t)
  @ shapes t
  @ names "behaviour" (named_behaviours t)
  @ words temporal @ entries Vocabulary.Measure Forms.Written
  @ List.filter (fun (o : Offers.offer) -> not (List.mem o.name declaring)) (keywords ())

let anything t =
  bodies t @ values t @ names "channel" (channels t)
  @ shapes t
  @ behaviours t @ keywords ()

(* The values of a setting. *)
let choices t (i : Pieces.item) =
  match Forms.find Choice i.word with
  | Some list when String.equal (Pieces.before t.p 1) i.word && Pieces.before t.p 2 = "" ->
    Some (List.map (word ~categories:[ Vocabulary.Setting ] Forms.Choice) list)
  | Some _ | None -> None

(* Within what a body does: after a channel's bracket, a comma, a dot. *)
let of_behaviour t (i : Pieces.item) =
  let last = Pieces.before t.p 1 and bracket = Pieces.bracket t.p in
  let bracket_word = Option.fold ~none:"" ~some:(fun k -> t.p.words.(k)) bracket in
  let before_bracket = match bracket with Some k when k > i.first -> t.p.words.(k - 1) | _ -> "" in
  let in_features = bracket_word = "{" && before_bracket = "," in
  if last = "~" || last = "<" || (last = "(" && Pieces.before t.p 2 = "omega") then
    Some (names "channel" (channels t))
  else if in_features && last = "." then Some (after_dot t i)
  else if in_features then
    let own = if i.word = "behaviour" then [] else bodies t in
    Some (names "feature" (features_at_hand t i) @ words [ "only" ] @ own)
  else if last = "," && bracket_word <> "{" && List.mem (Pieces.before t.p 3) [ "<"; "~" ] then Some []
  else None

(* Behaviours that are declared on a template with other features than those of the process do not fit. *)
let fitting t (i : Pieces.item) found =
  let of_process = match i.word with "process" | "fixed" -> solids_of_body t i | _ -> [] in
  let features s = List.sort String.compare (Known.features t.known s) in
  let fits o =
    match Hashtbl.find_opt t.known.on o.name with
    | Some s when of_process <> [] ->
      List.exists (fun own -> List.equal String.equal (features own) (features s)) of_process
    | _ -> true
  in
  List.filter fits found

(* After a dot in a behaviour there is another one, or what a module brings; after the bracket of a family, perhaps
   an argument; after that of `eps` or `push`, a number. *)
let next_behaviour t i =
  let last = Pieces.before t.p 1 in
  let called =
    match Pieces.bracket t.p with Some k when k > 0 && t.p.words.(k) = "(" -> t.p.words.(k - 1) | _ -> ""
  in
  let is_module = String.equal last "." && List.mem_assoc (owner t) t.known.modules in
  if is_module then exported ~only:(String.equal "behaviour") t (owner t)
  else if List.mem last [ "("; "," ] && List.mem called [ "eps"; "push" ] then
    values t @ entries Vocabulary.Function Forms.Called
  else if List.mem last [ "("; "," ] && Pieces.is_name called then
    behaviours t @ names "channel" (channels t) @ names "feature" (features_at_hand t i) @ values t
  else fitting t i (behaviours t)

(* The index of a process that is declared, or of a body within it (`c[i] : Cube`, `{c[i].top}`): a value, or a
   variable of a loop around it. *)
let declared_index t (i : Pieces.item) =
  let w k = if k < i.stop then t.p.words.(k) else "" in
  let rec closing k depth =
    match w k with
    | "" -> ""
    | "[" -> closing (k + 1) (depth + 1)
    | "]" -> if depth = 0 then w (k + 1) else closing (k + 1) (depth - 1)
    | _ -> closing (k + 1) depth
  in
  (* within the brackets of a behaviour there are indices of its names alone *)
  let rec nested j depth =
    if j <= i.first then false
    else
      match w j with
      | "]" | ")" | "}" -> nested (j - 1) (depth + 1)
      | "[" | "(" | "{" -> depth = 0 || nested (j - 1) (depth - 1)
      | _ -> nested (j - 1) depth
  in
  let is_index k =
    k = i.first + 2 || (Pieces.is_name (w (k - 1)) && nested (k - 1) 0)
    || (Pieces.is_name (w (k - 1)) && List.mem (closing (k + 1) 0) [ ":"; "." ]) in
  match (i.word, Pieces.bracket t.p) with
  | ("process" | "fixed"), Some k when k > i.first && String.equal (w k) "[" && is_index k ->
    let loops = List.filter (fun (l : Pieces.item) -> String.equal l.word "for" && l.first < i.first) t.p.items in
    Some (values t @ names "value" (unique (List.concat_map (Formula_places.integers t) loops)))
  | _ -> None

let begins_behaviour t (i : Pieces.item) bracket =
  let has_equals () = Array.exists (String.equal "=") (Array.sub t.p.words i.first (t.p.count - i.first)) in
  let within =
    match i.word with
    | "behaviour" -> has_equals ()
    | "process" | "fixed" -> String.equal bracket "["
    | _ -> false
  in
  within && List.mem (Pieces.before t.p 1) [ "["; "."; "+"; "="; "("; "," ]

let functions () = entries Vocabulary.Function Forms.Called

let in_law t =
  entries Vocabulary.Law Forms.Called @ values t @ functions ()
  @ words [ "choose"; "inertial"; "if"; "then"; "else" ]


(* What a body, a template or a part is made of. *)
let made_of t (i : Pieces.item) =
  let more = match i.word with "shape" -> [ "mesh"; "hull" ] | "compound" -> [ "decompose" ] | _ -> [] in
  solids t @ words more

let operators = [ "="; ":"; "+"; "*"; "<"; ">"; "("; ","; "-" ]

let of_item t (i : Pieces.item) =
  let last = Pieces.before t.p 1 in
  let bracket = Option.fold ~none:"" ~some:(fun k -> t.p.words.(k)) (Pieces.bracket t.p) in
  let is_open = bracket <> "" and after_operator = List.mem last operators in
  let special =
    match i.word with
    | "behaviour" | "process" | "fixed" | "bond" -> (
        match of_behaviour t i with None -> declared_index t i | found -> found)
    | "check" -> Formula_places.offers t i
    | _ -> None
  in
  match (special, i.word, last) with
  | Some found, _, _ -> found
  | None, _, _ when begins_behaviour t i bracket -> next_behaviour t i
  | None, _, "." -> after_dot t i
  | None, "behaviour", "on" -> solids t
  | None, ("process" | "fixed" | "compound" | "shape"), ("=" | ":") when bracket <> "[" -> made_of t i
  | None, _, "event" -> entries Vocabulary.Event Forms.Event
  | None, ("process" | "fixed"), _ -> words attributes @ values t @ words beginning
  | None, "check", ":" when not is_open -> words temporal @ formula t
  | None, "check", _ -> formula t @ names "value" (Formula_places.integers t i) @ words [ "U" ]
  | None, "motion", _ when is_open || after_operator -> in_law t
  | None, _, _ when is_open -> anything t
  | None, _, _ when after_operator -> values t @ functions () @ anything t
  | None, _, _ -> words beginning @ values t @ anything t

let offers t =
  match t.item with
  | None -> words beginning
  | Some i -> (
      match choices t i with
      | Some found -> found
      | None -> of_item t i)

(* {1 A place} *)

let begins_with prefix name =
  let n = String.length prefix in
  let lower = String.lowercase_ascii in
  String.length name >= n && String.equal (lower (String.sub name 0 n)) (lower prefix)

(* What cannot stand after the text of a check is left out. A text that has an error before the place, or is long,
   is not looked at. *)
let most_bytes = 1_000

let is_beginning text =
  let is_at_end (d : Scc_base.Diag.t) = d.span.start >= String.length text in
  match Scc_syntax.Parse.parse (Scc_base.Source.make ~name:"" text) with
  | Ok _ -> true
  | Error errors -> List.for_all is_at_end errors

let admitted text from found =
  let window, _, (all : Scc_syntax.Tokens.t) = Pieces.window text from in
  let last = ref window in
  Array.iteri
    (fun k begins ->
       let at = window + all.tokens.(k).start in
       if begins && at < from then last := at)
    all.restart;
  let before = String.sub text !last (from - !last) in
  let asked = Hashtbl.create 64 in
  let is_free o =
    (* to the grammar all names are alike, but for words that are names as well *)
    let is_plain = String.length o.name > 1 && Pieces.is_name o.name && not (Scc_syntax.Tokens.is_word o.name) in
    let name = if is_plain then "plain" else o.name in
    match Hashtbl.find_opt asked name with
    | Some known -> known
    | None ->
      let fits = is_beginning (before ^ name) in
      Hashtbl.add asked name fits;
      fits
  in
  if String.length before > most_bytes || not (is_beginning before) then found else List.filter is_free found

(* {1 What stands elsewhere}

   The names are known of a text that had the word at the place, half written, or a longer one that is erased by
   now. A name that stands nowhere else is none. *)

let is_letter c =
  match c with 'a' .. 'z' | 'A' .. 'Z' | '0' .. '9' | '_' | '\'' -> true | c -> Char.code c >= 128

(* The name of a word that has bars: `ā` is the co-name of `a`. *)
let unbarred word =
  if String.for_all (fun c -> Char.code c < 128) word then word
  else
    match (Scc_syntax.Tokens.read (Scc_base.Source.make ~name:"" word)).tokens with
    | [| { token = BARRED name | NAME name; _ }; _ |] -> name
    | _ -> word

(* Which of the names stand in the text, but for the word from here to there, and for comments. A module stands as
   the file of its import. *)
let written text ~from ~stop names =
  let n = String.length text and found = Hashtbl.create 64 in
  let rec after k fits = if k < n && fits text.[k] then after (k + 1) fits else k in
  let is_mark k mark = k + 1 < n && text.[k] = mark.[0] && text.[k + 1] = mark.[1] in
  let rec comment k depth =
    if k >= n then n
    else if is_mark k "*/" then if depth = 0 then k + 2 else comment (k + 2) (depth - 1)
    else if is_mark k "/*" then comment (k + 2) (depth + 1)
    else comment (k + 1) depth
  in
  let is_end c = c = '\n' || c = '\r' in
  (* most words of a long text begin otherwise *)
  let first = Array.make 256 false in
  Hashtbl.iter (fun name () -> if name <> "" then first.(Char.code name.[0]) <- true) names;
  let may_be c = Char.code c >= 128 || first.(Char.code c) in
  let rec scan quoted k =
    if k < n then
      match text.[k] with
      | c when is_letter c ->
        let next = after k is_letter in
        if may_be c && (next <= from || k >= stop) then begin
          let word = unbarred (String.sub text k (next - k)) in
          if Hashtbl.mem names word then Hashtbl.replace found word ()
        end;
        scan quoted next
      | '"' -> scan (not quoted) (k + 1)
      | c when is_end c -> scan false (k + 1)
      | '/' when (not quoted) && is_mark k "//" -> scan false (after k (fun c -> not (is_end c)))
      | '/' when (not quoted) && is_mark k "/*" -> scan false (comment (k + 2) 0)
      | _ -> scan quoted (k + 1)
  in
  scan false 0;
  found

let standing (known : Known.t) text ~from ~offset found =
  let rec word_stop k = if k < String.length text && is_letter text.[k] then word_stop (k + 1) else k in
  (* where nothing is written yet, the word after the place is another one *)
  let stop = if from = offset then offset else word_stop offset in
  let word = unbarred (String.sub text from (stop - from)) in
  let brought = Hashtbl.create 64 in
  List.iter (fun (_, all) -> List.iter (fun (_, name) -> Hashtbl.replace brought name ()) all) known.modules;
  let is_of_text o =
    match o.kind with
    | "channel" | "body" | "behaviour" | "shape" | "value" ->
      Option.is_none o.about && not (Hashtbl.mem brought o.name)
    (* a module may be named by its file, in other letters *)
    | "module" -> String.equal o.name word
    | _ -> false
  in
  let names = Hashtbl.create 64 in
  List.iter (fun o -> if is_of_text o then Hashtbl.replace names o.name ()) found;
  if Hashtbl.length names = 0 then found
  else
    let there = written text ~from ~stop names in
    List.filter (fun o -> not (is_of_text o) || Hashtbl.mem there o.name) found

let at known text offset =
  match Pieces.around text offset with
  | None -> (offset, [])
  | Some (from, p) ->
    let item = Pieces.here p in
    let found = offers { known; p; item } in
    let begun = String.sub text from (offset - from) in
    let fits = List.filter (fun o -> begins_with begun o.name) found in
    let fits = standing known text ~from ~offset fits in
    let fits = match item with Some { word = "check"; _ } -> admitted text from fits | Some _ | None -> fits in
    let kept = Hashtbl.create 64 in
    let is_new o =
      let known = Hashtbl.mem kept o.name in
      if not known then Hashtbl.add kept o.name ();
      not known
    in
    (from, List.filter is_new fits)

let import text offset =
  let rec line i = if i = 0 || text.[i - 1] = '\n' then i else line (i - 1) in
  let start = line offset in
  let written = String.sub text start (offset - start) in
  let after mark = Option.map (fun i -> start + i + 1) (String.rindex_opt written mark) in
  match String.split_on_char ' ' (String.trim written) with
  | "import" :: rest -> (
      let rest = String.trim (String.concat " " rest) in
      match (rest, after '"', after '<') with
      | "", _, _ -> None
      | rest, Some from, _ when rest.[0] = '"' && not (String.contains_from rest 1 '"') ->
        Some (from, `File (String.sub rest 1 (String.length rest - 1)))
      | rest, _, Some from when rest.[0] = '<' && not (String.contains rest '>') -> Some (from, `Library)
      | _ -> None)
  | _ -> None
