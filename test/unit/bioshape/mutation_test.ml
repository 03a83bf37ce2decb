(* Documents that somebody has damaged: whatever is done to one, it is read, or refused with places that are in
   it, and what is read can be written in both notations and read again. With [SCC_TIMES=n], n times as many. *)

open Scc_base
open Scc_syntax
open Scc_test_trees
open Scc_bioshape

let rec files folder =
  Sys.readdir folder |> Array.to_list |> List.sort String.compare
  |> List.concat_map (fun name ->
      let path = Filename.concat folder name in
      if Sys.is_directory path then files path else if Filename.check_suffix path ".sc" then [ path ] else [])

let contents path =
  let channel = open_in_bin path in
  let read () = really_input_string channel (in_channel_length channel) in
  Fun.protect ~finally:(fun () -> close_in channel) read

(* Small ones: a large one takes its time, and says no more. *)
let documents =
  lazy
    (files "../../../specs/models"
     |> List.filter_map (fun path ->
         match Parse.with_trivia (Source.make ~name:path (contents path)) with
         | Ok (model, trivia) -> Result.to_option (Write.model ~trivia model)
         | Error _ -> None)
     |> List.filter (fun text -> String.length text < 6_000)
     |> Array.of_list)

let pieces =
  [|
    "<"; ">"; "/>"; "</"; "&"; "&lt;"; "&#65;"; "&#x110000;"; "&x;"; "\""; "'"; "<!--"; "-->"; "--"; "<![CDATA[";
    "]]>"; "<?"; "?>";
    "<!DOCTYPE a [<!ENTITY b 'c'>]>"; "\000"; "\xFF"; "\xC3"; "\xC3\xA9"; "\r";
    "\n"; "=";
    " a='b'"; "xmlns=''"; "<nil/>";
    "<branch>"; "</branch>"; "<for>"; "("; ")"; "["; "]"; "{"; "}"; 
    "/*"; "*/"; "//"; "only "; "1/0"; "9"; ","; ".."; "<bioshape>";
  |]

let between state low high = if high <= low then low else low + Random.State.int state (high - low)
let sub s i j = String.sub s i (j - i)

(* A tag at or after the offset, from its [<] to after its [>]. *)
let tag s i =
  match String.index_from_opt s i '<' with
  | None -> (0, 0)
  | Some i -> (i, match String.index_from_opt s i '>' with None -> String.length s | Some j -> j + 1)

let mutated state documents s =
  let n = String.length s in
  let i = between state 0 n in
  let put at what = sub s 0 at ^ what ^ sub s at n in
  match Random.State.int state 9 with
  | 0 -> sub s 0 i
  | 1 -> put i pieces.(Random.State.int state (Array.length pieces))
  | 2 -> put i (String.make 1 (Char.chr (Random.State.int state 256)))
  | 3 -> sub s 0 i ^ sub s (min n (i + 1 + Random.State.int state 20)) n
  | 4 -> let a, b = tag s i in sub s 0 a ^ sub s b n
  | 5 -> let a, b = tag s i in put b (sub s a b)
  | 6 ->
    let a, b = tag s i and c, d = tag s (between state 0 n) in
    sub s 0 a ^ sub s c d ^ sub s b n
  | 7 ->
    let other = documents.(Random.State.int state (Array.length documents)) in
    sub s 0 i ^ sub other (between state 0 (String.length other)) (String.length other)
  | _ ->
    let b = Bytes.of_string s in
    if n > 0 then Bytes.set b i (Char.chr (Random.State.int state 128));
    Bytes.to_string b

let told text ds =
  let source name = Some (Source.make ~name text) in
  String.concat "" (List.map (Diag.render ~source) ds)

let placed text (d : Diag.t) =
  String.equal d.span.file "m.xml" && 0 <= d.span.start && d.span.start <= d.span.stop
  && d.span.stop <= String.length text

let judge text =
  let source = Source.make ~name:"m.xml" text in
  match Read.with_trivia source with
  | Error [] -> Alcotest.fail ("refused for nothing:\n" ^ text)
  | Error ds ->
    if not (List.for_all (placed text) ds) then Alcotest.fail ("places out of the text:\n" ^ told text ds ^ text);
    ignore (told text ds);
    false
  | Ok (model, trivia) ->
    let again = match Write.model ~trivia model with Ok s -> s | Error ds -> Alcotest.fail (told text ds) in
    (match Read.with_trivia (Source.make ~name:"m.xml" again) with
     | Ok (model', _) when Ast_equal.model model model' -> ()
     | Ok _ -> Alcotest.fail ("another tree:\n" ^ again)
     | Error ds -> Alcotest.fail (told again ds));
    let printed = Printer.model ~trivia model in
    (match Parse.parse (Source.make ~name:"m.sc" printed) with
     | Ok model' when Ast_equal.model model model' -> ()
     | Ok _ -> Alcotest.fail ("another tree in the language:\n" ^ printed)
     | Error ds -> Alcotest.fail (told printed ds));
    true

let times = match Option.bind (Sys.getenv_opt "SCC_TIMES") int_of_string_opt with Some n -> max 1 n | None -> 1

let mutations () =
  let documents = Lazy.force documents in
  Alcotest.(check bool) "there are documents" true (Array.length documents > 20);
  let state = Random.State.make [| 18 |] in
  let read = ref 0 in
  for _ = 1 to 3_000 * times do
    let text = ref documents.(Random.State.int state (Array.length documents)) in
    for _ = 0 to Random.State.int state 3 do
      text := mutated state documents !text
    done;
    if judge !text then incr read
  done;
  (* Both happen, or the test says nothing. *)
  Alcotest.(check bool) (Printf.sprintf "%d are read" !read) true (!read > 20 && !read < 2_400 * times)

let suite =
  ("damaged models in XML", [ ("documents", [ Alcotest.test_case "mutated" `Quick mutations ]) ])
