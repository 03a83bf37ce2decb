/**
 * The modelling language of scc (specs/language.md) for tree-sitter: the grammar of lib/language/syntax, rule by rule,
 * with the same precedences. test/editors/trees_test.py holds what it accepts, and its trees, against the real parser.
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

// From the loosest to the tightest, as in vocabulary.mly.
const level = {
  open: 10,
  leadsTo: 20,
  within: 30,
  implies: 40,
  or: 50,
  and: 60,
  not: 70,
  comparison: 80,
  withinArgument: 90,
  bracket: 100,
  sum: 110,
  product: 120,
  negation: 130,
};

/** One or more, with commas between. */
const list = (rule) => seq(rule, repeat(seq(",", rule)));
const parenthesized = (rule) => seq("(", rule, ")");
/** A word that is a name here. */
const asName = ($, word) => alias(word, $.name);
/** A sign, or a letter that stands for it. */
const sign = (text, ...letters) => choice(text, ...letters.map((letter) => alias(letter, text)));

const less = sign("<", "\u27E8", "\u2329", "\u3008");
const greater = sign(">", "\u27E9", "\u232A", "\u3009");
const dot = sign(".", "\u00B7", "\u22C5");
const parallel = sign("||", "\u2016", "\u2225");
const omega = sign("omega", "\u03C9");
const rho = sign("rho", "\u03C1", "\u03F1");
const eps = sign("eps", "\u03B5", "\u03F5");


// The words that are names wherever they cannot be words, as in expressions.mly.
const common =
  ("F G X U mod hull as where bond mass event dynamics collisions binding bonds blocked snap grid weld orient merge " +
    "union decompose resolution round steady push absorb").split(" ");
const quantifying = ["A", "E"];
const operators = ["AF", "AG", "AX", "EF", "EG", "EX"];

// No text may have control characters, but for those of space.
const text = "\\x00-\\x08\\x0A-\\x0B\\x0D-\\x1F\\x7F-\\x9F";
const commented = new RegExp(`//[^${text}]*`);
const quoted = new RegExp(`"([^"\\\\${text}]|\\\\[^${text}])*"`);

module.exports = grammar({
  name: "scc",

  // The scanner reads names, so that a word of the language is one only where a rule says so. It looks ahead for what only
  // the text after a token tells. `_never` is no token of any text: a rule that needs it refuses what led there. No rule
  // takes `_refused`.
  externals: ($) => [
    $.name,
    $.barred_name,
    "[",
    $._label_bracket,
    "/",
    $.block_comment,
    $._never,
    $._refused,
  ],

  word: ($) => $._word,

  extras: ($) => [/[ \t\f\r\n\uFEFF]/, $.line_comment, $.block_comment],

  rules: {
    source_file: ($) => repeat($._declaration),

    line_comment: () => token(commented),
    number: () => token(choice(/[0-9]+(\.[0-9]+)?([eE][+\-]?[0-9]+)?/, /2\^-[0-9]+/)),
    string: () => token(quoted),

    // Declarations

    _declaration: ($) =>
      choice(
        $.model_declaration,
        $.import_declaration,
        $.param_declaration,
        $.timestep_declaration,
        $.split_step_declaration,
        $.setting_declaration,
        $.resolution_declaration,
        $.round_declaration,
        $.shape_declaration,
        $.compound_declaration,
        $.behaviour_declaration,
        $.process_declaration,
        $.fixed_declaration,
        $.bond_declaration,
        $.for_declaration,
        $.network_declaration,
        $.motion_declaration,
        $.let_declaration,
        $.check_declaration,
        seq($._never, $._word),
      ),
    // What no name is, and no rule takes: the words of the language are told by it.
    _word: () => /[A-Za-z][A-Za-z0-9_']*/,

    model_declaration: ($) => seq("model", field("name", $._name)),

    import_declaration: ($) =>
      seq(
        "import",
        field("from", choice($.string, seq(less, $._name, greater))),
        optional(choice(seq("as", field("name", $._name)), $.selection)),
      ),
    selection: ($) => parenthesized(list($.selected)),
    selected: ($) => seq($._name, optional(seq("as", field("name", $._name)))),

    param_declaration: ($) =>
      seq(
        "param",
        field("name", $._name),
        choice(seq("=", field("value", $._expression)), seq("in", $.interval)),
      ),
    interval: ($) => seq(choice("[", "("), $._expression, ",", $._expression, choice("]", ")")),

    timestep_declaration: ($) => seq("timestep", $._expression, optional(choice("local", "steady"))),
    split_step_declaration: ($) => seq("split_step", $._expression),
    setting_declaration: ($) =>
      seq(choice("dynamics", "collisions", "binding", "bonds", "blocked"), field("value", $.name)),
    resolution_declaration: ($) => seq("resolution", $._expression),
    round_declaration: ($) => seq("round", choice($.name, asName($, "velocity")), $._expression),

    shape_declaration: ($) =>
      seq("shape", $._head, choice(seq("=", $._solid), seq("{", $.template, "}")), optional($.where)),
    compound_declaration: ($) =>
      seq(
        "compound",
        $._head,
        choice(
          seq("{", repeat($.part), repeat($.glue), "}"),
          seq("=", "decompose", $._decomposed, repeat($._attribute)),
        ),
        optional($.where),
      ),
    behaviour_declaration: ($) =>
      seq(
        "behaviour",
        choice($._head, $._places),
        optional(seq("on", $._reference)),
        "=",
        $._behaviour,
        optional($.where),
      ),
    process_declaration: ($) => seq("process", field("name", $._segment), "=", $._moving_chain),
    fixed_declaration: ($) => seq("fixed", field("name", $._segment), "=", $._still_chain),
    bond_declaration: ($) => seq("bond", $.bond),
    for_declaration: ($) => seq("for", list($.range), field("body", $.block)),
    block: ($) => seq("{", repeat($._declaration), "}"),
    network_declaration: ($) => seq("network", choice("nil", seq($.path, repeat(seq(parallel, $.path))))),
    motion_declaration: ($) =>
      seq("motion", choice($._law_of_all, seq(field("process", $.path), "=", $._law))),
    let_declaration: ($) => seq("let", field("name", $._name), "=", field("value", $._expression)),
    check_declaration: ($) => seq("check", field("name", $._name), ":", field("property", $._expression)),

    // Names and paths

    _common_name: ($) => choice($.name, ...common.map((word) => asName($, word))),
    _plain_name: ($) => choice($._common_name, asName($, "only")),
    _term_name: ($) => prec(level.open, choice($._plain_name, ...quantifying.map((word) => asName($, word)))),
    _name: ($) => choice($._term_name, ...operators.map((word) => asName($, word))),
    _member_name: ($) =>
      choice($._common_name, ...[...quantifying, ...operators].map((word) => asName($, word))),

    // `[`, be it that of a label or not.
    _bracket: ($) => choice("[", alias($._label_bracket, "[")),
    indices: ($) => seq("[", list($._expression), "]"),
    // In an expression a bracket after a name has its indices, whatever stands after it.
    _term_indices: ($) => seq($._bracket, list($._expression), "]"),

    _segment: ($) => seq($._name, optional($.indices)),
    _segments: ($) => choice($._segment, seq($._segments, dot, $._segment)),
    path: ($) => $._segments,

    _term_segment: ($) =>
      choice(
        $._term_name,
        prec(level.bracket, seq($._plain_name, alias($._term_indices, $.indices))),
        ...quantifying.map((word) =>
          prec(level.bracket, seq(asName($, word), alias($._term_indices, $.indices))),
        ),
      ),
    _later_segment: ($) =>
      choice(prec(level.open, $._name), prec(level.bracket, seq($._name, alias($._term_indices, $.indices)))),
    _term_segments: ($) => choice($._term_segment, seq($._term_segments, dot, $._later_segment)),

    _plain_path: ($) => choice($._name, seq($._plain_path, dot, $._name)),
    _polar_name: ($) => choice($._name, seq("~", $._name), $.barred_name),

    // Features, channels and bonds

    feature: ($) => choice($._segments, seq($._segments, dot, $.corners), $.corners),
    corners: ($) => seq("[", list($.path), "]"),

    // Before a feature of these, `only` is the word.
    _member_segment: ($) => seq($._member_name, optional($.indices)),
    _member_segments: ($) => choice($._member_segment, seq($._member_segments, dot, $._segment)),
    _member_feature: ($) => choice($._member_segments, seq($._member_segments, dot, $.corners), $.corners),
    _member: ($) => choice(alias($._member_feature, $.feature), seq("only", $.feature)),
    features: ($) => seq("{", optional(list($._member)), "}"),

    channel: ($) => seq(less, field("name", $._polar_name), ",", $.features, greater),
    weak_channel: ($) => seq(omega, "(", field("name", $._polar_name), ",", $.features, ")"),
    bond: ($) => seq(less, field("name", $._name), ",", "{", $.feature, ",", $.feature, "}", greater),

    // What a module declares, and what it is applied to

    _qualified: ($) => choice($._name, seq(field("module", $._name), dot, $._name)),
    arguments: ($) => parenthesized(list($._expression)),
    _reference: ($) => seq($._qualified, optional($.arguments)),
    _indexed_reference: ($) => seq($._qualified, $.indices),

    parameters: ($) => parenthesized(list($._name)),
    _head: ($) => seq(field("name", $._name), optional($.parameters)),
    _places: ($) => seq(field("name", $._name), $.indices),
    definition: ($) => seq(field("name", $._name), "=", $._expression),
    where: ($) => seq("where", list($.definition)),

    // Behaviours

    _behaviour: ($) => choice($.sum, $._behaviour_term),
    _behaviour_term: ($) =>
      choice(
        $.nil,
        $.behaviour_name,
        parenthesized($._behaviour),
        $.opening,
        $.weak_split,
        $.strong_split,
        $.delay,
      ),
    sum: ($) => seq($._behaviour, "+", $._behaviour_term),
    nil: () => "nil",
    behaviour_name: ($) => choice($._reference, $._indexed_reference),
    opening: ($) => seq($.channel, dot, $._behaviour_term),
    weak_split: ($) => seq($.weak_channel, optional($.push), optional($.odds), dot, $._behaviour_term),
    strong_split: ($) =>
      seq(rho, "(", "{", optional(list($.channel)), "}", ")", optional($.push), dot, $._behaviour_term),
    delay: ($) => seq(eps, parenthesized($._expression), dot, $._behaviour_term),

    push: ($) => seq("push", parenthesized($._expression)),
    odds: ($) =>
      seq(
        field("kind", $.name),
        choice(
          $.number,
          alias($._fraction, $.binary),
          alias($._odds_path, $.path),
          parenthesized($._expression),
        ),
      ),
    _fraction: ($) => seq($.number, "/", $.number),
    _odds_path: ($) => $._name,

    // Solids, and where they are

    _solid: ($) => choice($.template_name, $.hull, $.mesh, $.scaled),
    template_name: ($) => $._reference,
    hull: ($) => seq("hull", "{", repeat($.vertex), "}"),
    mesh: ($) => seq("mesh", $.string, optional($._mending)),
    grid: ($) => seq("grid", $._arithmetic),
    snap: ($) => seq("snap", $._arithmetic),
    // What is done to a mesh, in this order.
    _mending: ($) => choice(seq($.grid, optional($._mending_weld)), $._mending_weld),
    _mending_weld: ($) => choice(seq("weld", optional($._mending_orient)), $._mending_orient),
    _mending_orient: ($) => choice(seq("orient", optional($._mending_merge)), $._mending_merge),
    _mending_merge: ($) => choice(seq("merge", optional($._mending_snap)), $._mending_snap),
    _mending_snap: ($) => choice(seq($.snap, optional("union")), "union"),
    scaled: ($) => seq($._solid, "scaled", $._vector),

    template: ($) => seq("vertices", repeat($.vertex), "faces", repeat($.face)),
    vertex: ($) => seq(field("name", $._name), $._closed_vector),
    face: ($) => seq(field("name", $._name), "[", list($._name), "]"),

    _decomposed: ($) =>
      choice(
        alias($._file, $.mesh),
        alias($._braced_template, $.template),
        alias($._decomposed_scaled, $.scaled),
      ),
    _file: ($) => seq($.string, optional($._mending)),
    _braced_template: ($) => seq("{", "vertices", repeat($.vertex), "faces", repeat($.face), "}"),
    _decomposed_scaled: ($) => seq($._decomposed, "scaled", $._vector),

    _transform: ($) => choice($.translate, $.rotate, $.scale, $.matrix),
    translate: ($) => seq("translate", $._vector),
    rotate: ($) => seq("rotate", "quaternion", $._quadruple),
    scale: ($) => seq("scale", $._vector),
    matrix: ($) =>
      seq("matrix", "(", $._quadruple, ",", $._quadruple, ",", $._quadruple, ",", $._quadruple, ")"),
    _quadruple: ($) =>
      seq("(", $._expression, ",", $._expression, ",", $._expression, ",", $._expression, ")"),

    _attribute: ($) => choice($.mass, $.velocity, $.spin, $.absorb, $.placement),
    mass: ($) => seq("mass", $._arithmetic),
    velocity: ($) => seq("velocity", $._arithmetic),
    spin: ($) => seq("spin", $._arithmetic),
    absorb: () => "absorb",
    placement: ($) => seq("at", $._transform, repeat(seq("*", $._transform))),

    part: ($) => seq("part", field("name", $._name), ":", $._solid, repeat($._attribute)),
    glue: ($) => seq("glue", $.feature, "~", $.feature),

    // Processes

    label: ($) =>
      choice(
        seq(field("name", $._name), ":"),
        seq(field("name", $._name), alias($._label_indices, $.indices), ":"),
      ),
    _label_indices: ($) => seq(alias($._label_bracket, "["), list($._expression), "]"),
    behaviour_box: ($) => seq("[", $._behaviour, "]"),

    _moving: ($) => seq(optional($.label), $._solid, repeat($._attribute), $.behaviour_box),
    _still: ($) => seq(optional($.label), $._solid, repeat($._attribute), optional($.behaviour_box)),
    _moving_leaf: ($) => choice(alias($._moving, $.leaf), parenthesized($._moving_chain)),
    _still_leaf: ($) => choice(alias($._still, $.leaf), parenthesized($._still_chain)),
    _moving_chain: ($) => choice($._moving_leaf, seq($._moving_chain, $.bond, $._moving_leaf)),
    _still_chain: ($) => choice($._still_leaf, seq($._still_chain, $.bond, $._still_leaf)),

    // Laws of motion

    _law: ($) => choice($.inertial, $.choose, $.law),
    inertial: () => "inertial",
    choose: ($) => seq("choose", "{", list($.kick), "}"),
    law: ($) => seq($._expression, optional($.spinning)),

    // Without the name of a body, which would be taken for the beginning of an expression.
    _law_of_all: ($) => choice($.inertial, $.choose, alias($._standing_law, $.law)),
    _standing_law: ($) =>
      seq(
        choice($._closed_vector, alias($._name_call, $.call), alias($._standing_conditional, $.conditional)),
        optional($.spinning),
      ),
    _standing_conditional: ($) =>
      seq("if", $._expression, "then", $._expression, "else", $._expression),

    kick: ($) =>
      seq(optional(seq("for", list($.range), ":")), $._expression, optional($.spinning), optional($.weight)),
    spinning: ($) => seq("spin", $._expression),
    weight: ($) => seq("weight", $._expression),
    range: ($) => seq(field("name", $._name), "in", $.bounds),
    bounds: ($) => seq($._expression, "..", $._expression, optional(seq("if", $._expression))),

    // Numbers, vectors, truth values and formulas

    _closed_vector: ($) => choice($.vector, parenthesized($._expression)),
    vector: ($) => seq("(", $._expression, ",", $._expression, ",", $._expression, ")"),
    // One that an operator may follow which is not its own.
    _vector: ($) => choice($._closed_vector, alias($._plain_path, $.path), alias($._name_call, $.call)),
    _name_call: ($) => seq(field("function", $._name), alias($._values, $.arguments)),
    _values: ($) => parenthesized(optional(list($._expression))),
    _call: ($) => seq(field("function", $._term_name), alias($._values, $.arguments)),

    _expression: ($) =>
      choice(
        $.number,
        $.boolean,
        alias($._term_segments, $.path),
        $.co_name,
        alias($._call, $.call),
        alias($._behaviour_call, $.call),
        $.component,
        $.qualified_call,
        $._closed_vector,
        $.count,
        $.event,
        $.until,
        $.measured,
        $.negation,
        $.not,
        $.binary,
        $.leads_to,
        $.conditional,
        $.quantified,
        $.temporal,
      ),

    boolean: () => choice("true", "false"),
    co_name: ($) => choice(seq("~", $._name), $.barred_name),
    _behaviour_call: ($) =>
      seq(field("function", asName($, "behaviour")), alias($._values, $.arguments)),
    component: ($) => seq(choice(alias($._call, $.call), $._closed_vector), dot, field("axis", $._name)),
    qualified_call: ($) =>
      seq(alias($._term_segments, $.path), dot, field("function", $._name), alias($._values, $.arguments)),
    count: ($) => seq("count", "(", field("name", $._name), "in", $._over, ":", $._expression, ")"),
    event: ($) =>
      seq(
        "event",
        field("kind", choice($.name, asName($, "absorb"))),
        optional(alias($._values, $.arguments)),
      ),
    _over: ($) => choice($._expression, $.bounds),

    until: ($) =>
      seq(
        prec(level.bracket, seq(choice("A", "E"), $._bracket)),
        $._expression,
        "U",
        optional($.bound),
        $._expression,
        "]",
      ),
    measured: ($) =>
      seq(
        choice(
          seq(
            prec(level.comparison, seq($._expression, $._threshold)),
            prec(level.bracket, seq($._expression, $._bracket)),
          ),
          seq(prec(level.comparison, seq($._expression, "=")), "?", $._bracket),
        ),
        $._outcome,
        "]",
      ),
    _outcome: ($) =>
      choice(
        $._expression,
        seq($._expression, "U", optional($.bound), $._expression),
        seq($._expression, "at", $._expression),
      ),
    bound: ($) => seq("[", choice(seq("<=", $._expression), seq($._expression, ",", $._expression)), "]"),

    negation: ($) => prec(level.negation, seq("-", $._expression)),
    not: ($) => prec(level.not, seq("not", $._expression)),
    binary: ($) =>
      choice(
        prec.left(level.product, seq($._expression, $._product, $._expression)),
        prec.left(level.sum, seq($._expression, $._sum, $._expression)),
        prec(level.comparison, seq($._expression, choice($._threshold, $._equality), $._expression)),
        seq($._compared, choice($._threshold, $._equality), $._never),
        prec.left(level.and, seq($._expression, "and", $._expression)),
        prec.left(level.or, seq($._expression, "or", $._expression)),
        prec.right(level.implies, seq($._expression, "=>", $._expression)),
      ),
    // A comparison before another one is this, and leads nowhere: comparisons are not chained.
    _compared: ($) =>
      prec(level.comparison + 5, seq($._expression, choice($._threshold, $._equality), $._expression)),
    _threshold: () => choice(less, "<=", greater, ">="),
    _equality: () => choice("=", "!="),
    _product: () => choice("*", "/", "mod"),
    _sum: () => choice("+", "-"),

    leads_to: ($) =>
      choice(
        prec(level.leadsTo, seq($._expression, "leads_to", optional($.bound), $._expression)),
        seq(
          prec(level.leadsTo, seq($._expression, "leads_to")),
          prec(level.within, seq($._expression, "within")),
          prec(level.withinArgument, $._expression),
        ),
        seq($._led, "leads_to", $._never),
      ),
    _led: ($) => prec(level.leadsTo + 5, seq($._expression, "leads_to", optional($.bound), $._expression)),

    conditional: ($) =>
      prec(level.open, seq("if", $._expression, "then", $._expression, "else", $._expression)),
    quantified: ($) =>
      prec(
        level.open,
        seq(choice("forall", "exists"), field("name", $._name), "in", $._over, ":", $._expression),
      ),
    temporal: ($) =>
      choice(
        prec(level.open, seq(choice("possibly", "always", "eventually"), optional($.bound), $._expression)),
        seq(
          choice("possibly", "always", "eventually"),
          prec(level.within, seq($._expression, "within")),
          prec(level.withinArgument, $._expression),
        ),
        prec(level.not, seq(choice("AF", "EF", "AG", "EG"), optional($.bound), $._expression)),
        prec(level.not, seq(choice("AX", "EX"), $._expression)),
      ),

    // After an attribute stands arithmetic alone, and no index outside brackets, so that `<` after it opens a bond and
    // `[` a behaviour.
    _arithmetic: ($) =>
      choice(
        $.number,
        alias($._plain_path, $.path),
        alias($._name_call, $.call),
        alias($._arithmetic_component, $.component),
        $._closed_vector,
        alias($._arithmetic_negation, $.negation),
        alias($._arithmetic_binary, $.binary),
      ),
    _arithmetic_component: ($) =>
      seq(choice(alias($._name_call, $.call), $._closed_vector), dot, field("axis", $._name)),
    _arithmetic_negation: ($) => prec(level.negation, seq("-", $._arithmetic)),
    _arithmetic_binary: ($) =>
      choice(
        prec.left(level.product, seq($._arithmetic, $._product, $._arithmetic)),
        prec.left(level.sum, seq($._arithmetic, $._sum, $._arithmetic)),
      ),
  },
});
