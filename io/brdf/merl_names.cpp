#include "io/brdf/merl_file.h"

#include <algorithm>

namespace refraster {
namespace {

struct Known {
  std::string_view sha256, name;
};

// The 100 files of the MERL BRDF database, version 2.0 of February 2006, by the hash of their bytes, in its order.
constexpr Known known[] = {
    {"0205cb97485a79a6c3bc358c63d9a84dd62e275a498a7384cdf763312bf8f2ab", "orange-paint"},
    {"05b389a759d555b6f7a45ae33763d555b93d373b4d6db2fe0c52ca461321a7b0", "specular-green-phenolic"},
    {"09acfbb1d8e7eb63872c25edffe6ab65e1f643d2e9522612cc80a7ec8eb60a08", "specular-violet-phenolic"},
    {"0a6deb221291901b945240cf7462e44d2c376ae8e9588a50eb340178d1d5df26", "polyurethane-foam"},
    {"1437d5d250b2b53a71a2263891095dbfd4593dc2973ce23ab17a52302952c661", "black-oxidized-steel"},
    {"15684f9854ada6947ba3a7790b00e47e638edf611b1b0b00b8354cb5ca25fe61", "grease-covered-steel"},
    {"156c0c45d7719ebd41ddf46c4d4018f161a205fbbc7cfba15b2c9268f832afa7", "green-acrylic"},
    {"1d0fa4e0a4926a905db7fa1f0ab7602751f707062ad7d6d148ce1fe1d00f808a", "blue-rubber"},
    {"1d73d733e42b3b5547c5875c55f74855d4c4a9a7ef2531601121c892416905f5", "natural-209"},
    {"1f363c976b2017077a9df4941fe50281e6b0f0f90addcb2d46841cc5a767b35b", "silver-metallic-paint"},
    {"220be5b0516d8945b4cd7888912d85832df5d2a2b389e34254a3b6510e0d89fd", "dark-specular-fabric"},
    {"24988c19ab79c2849a7028fdd87b0db680e4b5b76f92eda761cfd63712bb062e", "special-walnut-224"},
    {"2e6988e9ae6796d19d93fb3967c1964f0ef2c43fd75e86556ecfba273500acbb", "red-specular-plastic"},
    {"2f5af652e6f1de7281e59995f3d0921f7a773455d380938ff4984e239ed19ab3", "green-metallic-paint2"},
    {"303bebb8c1704527d075023eeccb441f744dcc450bf20ed359910aaab206baad", "nylon"},
    {"36a65d59a4e0b5ad4ac777285124c435ed4da776d7c28ba01c1330be9a38a340", "blue-acrylic"},
    {"3c0fd0d9a9932a772854eca3bae8b6506659cab63c2820ee918304265709713b", "specular-maroon-phenolic"},
    {"424c1ac827b32898feb85b634ad02812d232d872c2c2f4e7db5d283ef34757eb", "pink-felt"},
    {"43810d5889387166c57812ce572d14aa335c7317f0fdbc3d7cb99a1c02e74d28", "pure-rubber"},
    {"482be11e7110b993532cfe95651bffda643033cd4e765b8e5184023e2f4ac440", "black-soft-plastic"},
    {"485520b38ef70cba382d6fdb20a28eb794a7fc8ffc4bfe3e1eb0936e026073ef", "silicon-nitrade"},
    {"4a18a679425b394e8d4df6318c97946456793ee6e6299eb9c86a6b1967087043", "brass"},
    {"4ac85beedf563dbbb6ff3d47faef97f2fa2efa6450458ca912726306ccbe7947", "pvc"},
    {"4cbf3dc33fc4376cab25e83183393de2d4f4576f220a19eb7be51cdd0734b8fc", "red-fabric2"},
    {"4d31a9f44db931ceb24bf5d58f1cb0356fdbb3ec7e2050f14b54682466af027d", "aventurnine"},
    {"4e8ebe0edeee7f1296acaf6b368196534389d56ab1605eaed4f30d98070947f2", "colonial-maple-223"},
    {"50ed2d6430f3a019b0f3c59c796c6879d6d6fe7d2107c0ee26115792085ad9d2", "pearl-paint"},
    {"5b74c001f2235255e2db1a03a8cf3627ecd47c4ce8a8ea5d7da5dc16c0ece3b7", "nickel"},
    {"5e16ced69616cf4ee0b4962cf2d4d6a0295ed1ae246dffdabc549255da712619", "delrin"},
    {"5f65b9ba56889b2480d874b8f5cc195064d35c5af0d42b0d4bca72b7f9c2fbf4", "polyethylene"},
    {"61e3ee38c2b541abe755dc0f1541c9cf572306409b9eccec849fa85b9811f3b0", "specular-orange-phenolic"},
    {"657deb3dc9479ca07c710659c5964cc0dc14576b36ac1b4e4549639758e21ae0", "pink-fabric"},
    {"65ea5c3b6a7e48a1be05b83237f55eb81e8134f6f96aa28aed1dd48645d69396", "specular-black-phenolic"},
    {"660ea616a505c0b6ac248c8b5f432f1e780f6f4b2226fe1249c37a1fbd83fdcb", "white-diffuse-bball"},
    {"674a7c9ff1f4a0d830652eca06199dc24056eb3e6f91b11e47553aa2079630a1", "white-fabric2"},
    {"67778f2d7c361838bf64bcd5cf6497ec917452dd1318601bf110b83f3a1b18e0", "gray-plastic"},
    {"69c493d7f36fa5267d15948a616056f9bc84e352ec6db49b64afe6ff232e27d6", "gold-metallic-paint"},
    {"6c66ca184949c6b023fb2b13427e863f79d901b51aecb8af740230a3a1c6f519", "yellow-paint"},
    {"6f540356571a29616c2ad9e123e8b2530f41aec13ce1cd330958cf552ca592c6", "pink-fabric2"},
    {"6fa71285a697acc96d869a4d6d8c903f7c5cd2eafeff8f191ff730c90e1e5f68", "gold-paint"},
    {"6fc96fa98570616c643e4b8125bfc59e00b186da63028e75b0ceb1ecd8eca543", "white-paint"},
    {"745b9868b6c28b1d7e4132879a046e066f5d4c45516e940de0dc0811bdacf1ea", "specular-yellow-phenolic"},
    {"75f2555e75d2a58864f223ad6269b84279bc2793d32a6f987e1768a94c065808", "steel"},
    {"764f5fa1998ef9fd7fa505ac7892ceb539bdf2c484bd5db02bd110e3500f3b08", "pink-jasper"},
    {"768d4f17fea81f1b281ec1c77e2d1c7b4a0f3bcc2975849e00c3330ea47af3c9", "chrome-steel"},
    {"76e0e091072437d7dc478b3fc6f3952c5fc60c5c9705f5c175a7ab9a4525f3e7", "color-changing-paint2"},
    {"77956cd5d05f8c8f524ef811a51f8be0c19cec8fb19e3e8d4b3383f057014deb", "color-changing-paint1"},
    {"77f633a4bd13b38815cab2d3e26ed159b7d7c7b926a9842c696db22c61e03d09", "green-latex"},
    {"7c09a391afb189e80df062dcffa6c30d68bbc00b1b5bf0717e8c9e9578ba894c", "gold-metallic-paint3"},
    {"7f4db72b17deee9e9f27cd72caddd3ff4cb9a91e049577a29ec450c6cb9a6190", "blue-metallic-paint2"},
    {"8084adfb95c5cd9ff4943da0826d46f42bcd9afab667b6fdf6fc543bff0cbca6", "violet-acrylic"},
    {"80fac7777bf9bad943ee088cebbb8fa135d92c28a62b5c6bcd9b65539f469c5a", "black-obsidian"},
    {"81eeb276660a56b8f70eb0dd4d4c07d6b6cd2d9074f3d9a15e86b041895ad978", "ipswich-pine-221"},
    {"82d2cdafe51665062245f1881bc320cdfce1cbcde156b9f604641128e40ab9c3", "silver-metallic-paint2"},
    {"84519c4158b66a6abfa0f7e3ab83143983d4a2a638d8c254e0b16dd3950575df", "teflon"},
    {"8460a7d6e99aa143ba7cbd1801079ef95a4eb1f1ed93585b60ebb00fccb3c41c", "white-marble"},
    {"8493ab45577ac0c421149e52cac60225ef265dd06c74459c34f44f43acaf1da8", "white-fabric"},
    {"84fee448e2fdf3f5bec5554412c44839f9e422d1283ac54bb0f28e822b25e9ac", "cherry-235"},
    {"86389660b984e9ff1d31ecb1afb3d63e3fa71e7e90149d56b56d5dd6e707b6b2", "black-phenolic"},
    {"863ef6f6909d60286dfa8dc6487add1975796fc996872b85aa879e5d6a3e1b2c", "color-changing-paint3"},
    {"8ca888458aff42b6ebc95329ef1552782e7cb4c2ddc6df060a5afe5ffa58ba8d", "chrome"},
    {"8df9d49f4f5e2e0b52583d46b3b5ab9641a028efa3c9049bc13c01a2783911ae", "specular-blue-phenolic"},
    {"90d2ee46c0d0f224a87849796241c946ab8cf33c17f07177339d037f6fa945b7", "green-metallic-paint"},
    {"92107197f14e185fe578f7886472c05eaa4b00b64649c685e8e40c121b9e1634", "purple-paint"},
    {"9375f68d1acf69e6c26cf814375e63302250667a78d19165814ea832a67e5e70", "light-brown-fabric"},
    {"9661f2187918d3db5cef4c2628483ce287bf04fa19252e871747002b9de962e2", "red-fabric"},
    {"96f1a800f8885c2896d415cfc71aeb1f5508c6db9ed200648644987c950167d2", "dark-blue-paint"},
    {"98975c6416bb806cf348c04a40b28a0c903aaa64fd353c2d7ae96f892b618c2f", "neoprene-rubber"},
    {"9c6975e11860b80ba739236e5c092041e917209bb229e95afb8bbf6356a12f7d", "silver-paint"},
    {"a1bd0374278810558de904056a73e08fdabeffd4260d816541e47467d4a4e962", "green-plastic"},
    {"a3ea39612719e4638e883c5ed42b2ca47dcdd6bab846546c6deec1031a1f1a6e", "green-fabric"},
    {"a670c1e46a9b2b9077a49cfc6c90543d3bd04950f4d2cde632c402b694aed085", "gold-metallic-paint2"},
    {"a8810e925efc22fd633f9653393dca855d94867f0d0a0f84c6b746e42a1b266b", "two-layer-silver"},
    {"b2e71a67418915cd985bf02cef1b9a5b29a8ca3173919335ec0f39c98426cf7e", "red-metallic-paint"},
    {"bcd236e94bc0214ec5551a99403db5167c3182b4a204afa56d30fadc4c52736a", "dark-red-paint"},
    {"c09de644e09bbaccd74a2d92b4c49599866609522e826196b9c62eb7233e6a39", "maroon-plastic"},
    {"c1daab4ee99c386cb6dcd31ca2d30734504b47456b0d7dc38f1737596e373ba1", "red-phenolic"},
    {"c27c844294514eb5f69d3c820484b9c97834394ba58e20acb993630685cc3a45", "hematite"},
    {"c3aadbfd93757e1b1b5459588d36939d1144b4e182947546f380729f1bc9a6a7", "pickled-oak-260"},
    {"c3e49d638d96245845b5361ccec502af69923bbedd09b74a0a058e3f6e9e90fc", "alumina-oxide"},
    {"c6562ae99d66c10c9e4f9cf56df9df2e07701ff4cf680732d118e518066fd7ed", "beige-fabric"},
    {"c72ccdc487a6c2cf4e0a0adf1a7d7f235db048d934e4e850b61024b50b4b3ee8", "fruitwood-241"},
    {"c89c13bec30668da0f16b9d5f9be9d4fb37578c5640c0a0cc5e9a9ba502e4c1a", "white-acrylic"},
    {"ca43554a1b0afd9bcb437113bd431742a9918f744e14675af917f89e0eba74c8", "aluminium"},
    {"cc036db74087f380747a0746d39dd1e4be359c409fa729214a894bd883a4757e", "yellow-plastic"},
    {"cd8957418c49a898c0d044428c055e6e27abd917d232a67a5999a29ab7998435", "yellow-phenolic"},
    {"cf75a504f0583fdc41802dfa658aae94738760ee02d6e8118b32486ced764884", "light-red-paint"},
    {"d1c8fc446d24fee00cfb8ab5278f96c3b43f8d8e7197f5d8260d7c0eac12d374", "two-layer-gold"},
    {"d4d0d80832d69c21cf850a85f29ff4884da59f9aa922d8a7d62b4f377a9f08cc", "pink-plastic"},
    {"d6407989bc5e8a0c12aa7a2096ac212e707f3e89b8361bda08226edb37eb3eb4", "red-plastic"},
    {"d6506c69e44430bfe8ea676f3950599ca3a6bfb1f46b9906da336d13991bd37d", "alum-bronze"},
    {"dab007a599a34eedbc3a1afe6757b24ac5943798e1d45713d3d1c7f51f0b996a", "specular-white-phenolic"},
    {"ddf0c7b5369a86023470dd55d3c28cd48a8fe41944885dd6e6dc3f93c8d5b832", "ss440"},
    {"e1c9bc7b2404f14a7afbef842c03125fee439cc2287f31331b908846476876ad", "tungsten-carbide"},
    {"e3dee274e8a8a74ab371cf02c9f912fa87defe5eea302202b80ea31107b1504d", "blue-fabric"},
    {"e4821c9618b0eb931c536548af6b58bae86f2752200e3a24b4e44800b87516b5", "specular-red-phenolic"},
    {"e6a87a32c16f314b5e56f79ccb122002e8f82501ae741b84f306328b24785c20", "blue-metallic-paint"},
    {"f13ee6d8a646855da406e59900d2c0c9bdc5f322610031b27e0d97d9ed1b6100", "violet-rubber"},
    {"f776212f60943d45bdaff0215e34c6af287a6d0d180fc4d39387d2ec6b9d0995", "yellow-matte-plastic"},
    {"fc8da452ce368e9327faa064dedd03edd8ad905940eb9114e9e9d980a8b9ccf7", "black-fabric"},
};
static_assert(std::ranges::is_sorted(known, {}, &Known::sha256));

} // namespace

std::string_view merl_material_name(std::string_view sha256) {
  const Known* const found = std::ranges::lower_bound(known, sha256, {}, &Known::sha256);
  return found != std::end(known) && found->sha256 == sha256 ? found->name : std::string_view();
}

} // namespace refraster
